// What each pass of the step must do at least, per point: floating-point operations and bytes moved. Counted from the
// kernels by hand (benchmarks/README.md), for `terp bench`.
#pragma once

#include "simulation/workspace.hpp"

#include <string_view>

namespace terp {

struct PassCost {
  double flops = 0.0;  ///< per point; a multiply-add counts two, an elastic point
  double bytes = 0.0;  ///< per point, read and written, each row of a block once per pass
};

/// Costs of the passes over points; passes over nodes and leavers count zero.
std::array<PassCost, n_passes> pass_costs(std::string_view scheme);

}  // namespace terp
