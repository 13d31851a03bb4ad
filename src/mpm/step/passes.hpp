// The passes of the step: their names, and what each must do at least, for `terp bench` (benchmarks/README.md).
// Not for: what they do (score.def). A new pass is a line of passes.def and its line in the score.
#pragma once

#include "mpm/schemes/scheme.hpp"

namespace terp {

enum Pass {
#define TERP_PASS(name, title, cost) name,
#include "mpm/step/passes.def"
#undef TERP_PASS
  n_passes
};

inline constexpr std::array<const char*, n_passes> pass_names{
#define TERP_PASS(name, title, cost) title,
#include "mpm/step/passes.def"
#undef TERP_PASS
};

/// Cost of each pass per point with a scheme.
std::array<PassCost, n_passes> pass_costs(const Scheme& scheme);

}  // namespace terp
