// The slope of the pressure within the cells, in a step. Not for: what is done with it (balance_passes.hpp,
// mpm/features/pressure_balance.hpp).
#pragma once

#include "mpm/kernels/cell_balance.hpp"

#include <vector>

namespace terp {

/// Of a node, while the acceleration of the cells is found.
struct BalanceNode {
  Real mass = 0.0;                ///< 0: the node does not move [kg per m]
  Vec<2> v{0.0, 0.0};             ///< at the start of the step [m/s]
  Vec<2> force{0.0, 0.0};         ///< out of balance without that of the slope of the pressure [N per m]
  Vec<2> acceleration{0.0, 0.0};  ///< [m/s^2]
};

struct BalanceScratch {
  std::vector<CellBalance> cells;  ///< shape [n_occupied]
  std::vector<BalanceNode> nodes;  ///< shape [n_nodes]
};

}  // namespace terp
