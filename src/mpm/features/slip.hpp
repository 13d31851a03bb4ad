// Soils that slip in the cells that they share, in a step. Not for: how they slip (mpm/features/cut_cells.hpp).
#pragma once

#include "mpm/features/block_slip.hpp"

#include <vector>

namespace terp {

struct SlipModel {
  int row = -1;  ///< of the points: plastic work of the last step
};

struct SlipScratch {
  std::vector<BlockSlip> blocks;  ///< shape [n_blocks]
};

}  // namespace terp
