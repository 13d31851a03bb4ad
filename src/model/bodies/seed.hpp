// First material points: n x n per cell, inside the outlines of bodies; later bodies lie on top of earlier ones.
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "model/bodies/body_outline.hpp"

namespace terp {

/// A new point: where, in which cell, of which body, and how much volume it stands for.
struct Seed {
  Vec<2> x;      ///< [m]
  Vec<2> local;  ///< xi, eta in the cell
  Index cell;
  Index body;
  Real volume;  ///< Omega_p [m^2]
};

/// Points in order of cell, then body, then row, then column of the lattice. The volumes of a body add up to the area
/// of its outline in the mesh, less what later bodies cover, to round-off. The outlines are sound: check_outline.
std::vector<Seed> seed_points(const Mesh<2>& mesh, std::span<const BodyOutline> bodies);

}  // namespace terp
