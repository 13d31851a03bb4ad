// Walls that let no water through: the mesh of the flow has their nodes twice, once for each side.
// Not for: the soil, which moves on the mesh as it is.
#pragma once

#include "model/water/water_case.hpp"
#include "mpm/mesh/mesh.hpp"

#include <functional>
#include <span>
#include <vector>

namespace terp {

struct WalledMesh {
  SharedMesh mesh;           ///< cells as before; only `nodes` and `cells` know of the walls
  std::vector<Index> twins;  ///< of each node that was added, in their order: the node at its place

  /// Values of the nodes of the mesh as it is: along walls the mean of both sides. NaN: counts on neither.
  std::vector<Real> joined(std::span<const Real> values) const;
};

/// has_soil: of a place; cells without soil do not join the sides of a wall that ends at the ground. Throws InputError
/// where a wall does not run along sides of cells.
WalledMesh with_walls(
    const SharedMesh& mesh, std::span<const WallCase> walls, const std::function<bool(Vec<2>)>& has_soil);

}  // namespace terp
