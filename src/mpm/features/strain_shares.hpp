// strain_shares = "transposed" in a step. Not for: what schemes do with it (mpm/features/share_ratio.hpp).
#pragma once

#include "mpm/mesh/element.hpp"

#include <vector>

namespace terp {

struct StrainSharesScratch {
  std::vector<PerGauss<Quad4>> ratios;  ///< shape [n_blocks]
};

}  // namespace terp
