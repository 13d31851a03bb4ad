// What a step does whatever its scheme and its features (score.hpp).
#pragma once

#include "mpm/step/score.hpp"

namespace terp {

/// In this copy of the kernels.
std::span<const Kernel> core_kernels();

}  // namespace terp
