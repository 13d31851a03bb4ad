// Whether material points hold more volume than there is room where they lie: tables of points may say anything.
// Not for: how points of one place share it (overlay).
#pragma once

#include "mpm/mesh/mesh.hpp"

#include <optional>
#include <vector>

namespace terp {

/// What lies in each cell, shape [n_cells].
struct CellContents {
  std::vector<Real> volume;   ///< sum over its points [m^2]
  std::vector<Real> largest;  ///< largest of them [m^2]
};

/// A cell that with the cells around it holds too much, or a point that is too large for it.
struct Overfull {
  Index cell = 0;
  std::vector<Index> around;  ///< the cell and all that share a node with it
  bool by_one_point = false;
  Real volume = 0.0;  ///< in all of these, or of the point [m^2]
  Real area = 0.0;    ///< of all of these, or of a mean cell of them [m^2]
  Real limit = 0.0;   ///< of the volume [m^2]
};

/// Cells that share a node with the cell, and itself; ascending.
std::vector<Index> cells_around(const Mesh<2>& mesh, Index cell);

/// The cell with the most volume over the limit, if any is over it. Points are places: the soil of those that lie in
/// some cells may reach beyond them, by its own size s at most, so that there is room for
///   area + length of the outline s + 4 s^2,   s^2 the largest volume of a point there, but no more than a mean cell.
/// Soil of many cells that lies there twice is over it from 2 x 2 points per cell on, a layer of two cells is not
/// (points_of_files looks at places, too); points on a lattice across the cells are not. One point may have the volume
/// of 2 x 2 cells: farther apart, points leave cells between them empty.
std::optional<Overfull> find_overfull(const Mesh<2>& mesh, const CellContents& contents);

}  // namespace terp
