// The points of one body in a cell that outlines cut: one at the centroid of each piece of the lattice, slivers merged
// into a neighbour. Not for: whole cells, or which bodies matter in a cell (seed.hpp).
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "model/bodies/overlay.hpp"

namespace terp {

/// Pieces smaller than this share of their part of the lattice are merged. A fifth keeps the masses of points within a
/// factor of six or so of each other; a whole part that takes a sliver moves by less than a sixth of the way to it
/// (decision 0026).
inline constexpr Real smallest_share = 0.2;

/// A point to be: a piece of one part of the lattice, or several such pieces.
struct Piece {
  std::array<Index, 2> part;  ///< column and row in the lattice
  Vec<2> x;                   ///< centroid, relative to the cell's centre [m]; of a whole part the lattice point
  Real volume;                ///< [m^2]
  Real whole_volume;          ///< of the part of the lattice [m^2]
  bool is_whole;              ///< the part, nothing less and nothing more
  bool stays_alone = false;   ///< too small, but no neighbour can take it
};

/// A cell in equal parts of its local coordinates. The sides of a part are straight.
struct Lattice {
  const CellGeometry<Quad4>& cell;
  std::array<Index, 2> n;  ///< parts along xi and eta
};

/// Middle of a part in local coordinates.
Vec<2> middle_of_part(const Lattice& lattice, std::array<Index, 2> part);

/// Corners of a part, relative to the cell's centre [m].
std::array<Vec<2>, 4> corners_of_part(const Lattice& lattice, std::array<Index, 2> part);

/// Volume of a part [m^2]. Exact: detJ is linear in xi and eta, so its value in the middle is its mean.
Real volume_of_part(const Lattice& lattice, std::array<Index, 2> part);

/// Pieces of a body in a cell, row by row. Their volumes add up to the body's area in the cell, their moments to its
/// moments but for the whole parts, which are not moved.
std::vector<Piece> cut_cell(const Lattice& lattice, const Overlay& overlay, Index body);

}  // namespace terp
