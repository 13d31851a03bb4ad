// Which cell contains a position: a walk over the crossed sides from a first guess, then a search of all cells
// near it.
#pragma once

#include "mpm/mesh/mesh.hpp"

namespace terp {

/// A cell accepts a position when the local coordinates are within 1 + this.
inline constexpr Real location_tolerance = 1e-10;

struct Location {
  Index cell;    ///< the containing cell; for a position outside the mesh the last cell of the walk
  Vec<2> local;  ///< xi, eta in that cell
  bool inside;
};

/// Cells are half-open, [-1, 1) in xi and eta, so that a position on a side has one owner; the mesh's own boundary is
/// closed.
Location locate(const Mesh<2>& mesh, Vec<2> x, Index first_guess);

/// The same without a first guess. For a position outside the mesh the cell is some cell, not the nearest.
Location locate(const Mesh<2>& mesh, Vec<2> x);

/// Global position of local coordinates in a cell [m].
Vec<2> place_in_cell(const Mesh<2>& mesh, Index cell, Vec<2> local);

/// Local coordinates moved into [-1, 1].
Vec<2> clamp_to_cell(Vec<2> local);

}  // namespace terp
