// Nonlocal softening in a step: what is spread over the length of each material, and how far.
// Not for: how it is spread (softening_passes.hpp, mpm/kernels/node_diffusion.hpp).
#pragma once

#include "mpm/kernels/node_diffusion.hpp"

#include <utility>

namespace terp {

struct SofteningModel {
  NodeDiffusion diffusion;
};

/// At the corners of one cell: sums over the points that can soften.
struct CornerSoftening {
  PerCorner<Quad4> volume;          ///< [m^2]
  PerCorner<Quad4> increment;       ///< volume times increment [m^2]
  PerCorner<Quad4> length_squared;  ///< volume times l^2 [m^4]
};

/// Cells and nodes that softening can reach in a step.
struct SofteningReach {
  std::vector<std::uint8_t> has_cell, has_node;  ///< shape [n_cells], [pack_width * n_groups] of NodeDiffusion
  std::vector<Index> cells;                      ///< in the order in which they are found

  void enter(Index cell)
  {
    if (std::exchange(has_cell[cell], 1) == 0) cells.push_back(cell);
  }
  bool has_any_of_group(Index g) const
  {
    const auto* nodes = &has_node[pack_width * g];
    return std::any_of(nodes, nodes + pack_width, [](auto has) { return has != 0; });
  }
  void clear()
  {
    cells.clear();
    std::ranges::fill(has_cell, 0);
    std::ranges::fill(has_node, 0);
  }
};

struct SofteningScratch {
  NodeSpread spread;
  std::vector<CornerSoftening> corners = {};    ///< shape [n_occupied]
  std::vector<std::uint8_t> cell_softens = {};  ///< whether a point of a cell softened, shape [n_occupied]
  SofteningReach reach = {};
};

}  // namespace terp
