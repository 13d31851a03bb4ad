// The running mean of the out-of-balance force, of damping with an averaging time (decision 0043).
// Not for: the damping itself (mpm/kernels/damping.hpp).
#pragma once

#include "math/types.hpp"

#include <span>
#include <vector>

namespace terp {

struct MeanForceState {
  std::vector<Vec<2>> force;  ///< [N per m], shape [n_nodes]
};

/// Zero again at nodes without soil, where soil that comes back begins anew. active_nodes: ascending.
void forget_mean_force(std::span<const Index> active_nodes, MeanForceState& mean);

}  // namespace terp
