// First material points: n x n per cell, inside the outlines of bodies; later bodies lie on top of earlier ones.
#pragma once

#include "mesh/mesh.hpp"
#include "points/polygon.hpp"

namespace terp {

/// What to fill with points.
struct BodyOutline {
  Polygon polygon;
  std::array<Index, 2> points_per_cell;
};

/// A new point: where, in which cell, of which body, and how much volume it stands for.
struct Seed {
  Vec<2> x;         ///< [m]
  Vec<2> local;     ///< xi, eta in the cell
  Index cell;
  Index body;
  Real volume;      ///< Omega_p = share of the cell by detJ at the point [m^2]
};

/// Points in order of cell, then row, then column.
std::vector<Seed> seed_points(const Mesh<2>& mesh, std::span<const BodyOutline> bodies);

}  // namespace terp
