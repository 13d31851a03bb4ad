// volume_change = "soil" in a step. Not for: what schemes do with it (mpm/features/volume_gradient.hpp).
#pragma once

#include "mpm/kernels/internal_force.hpp"
#include "os/memory.hpp"

namespace terp {

struct VolumeChangeScratch {
  ZeroedArray<VolumeGradient<Quad4>> gradients;  ///< shape [n_groups at least]
};

}  // namespace terp
