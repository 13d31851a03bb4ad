// Shares that overlap, in a step. Not for: the shares (mpm/kernels/overlap.hpp), nor the sums over patches
// (mpm/features/patch_group.hpp).
#pragma once

#include "mpm/features/patch_values.hpp"

namespace terp {

struct OverlapModel {
  int inverse_extent = -1;  ///< row of the points
};

struct OverlapScratch {
  PatchValues patches;
};

}  // namespace terp
