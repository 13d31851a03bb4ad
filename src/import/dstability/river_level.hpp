// A stage of a file with its river at another level: `terp import --river`. docs/dstability.md, "Another water level".
// Not for: which heads move by how much (trigger.hpp), a river that moves during the run (a trigger).
#pragma once

#include "import/dstability/river_side.hpp"

namespace terp {

struct RiverLevel {
  StixProject project;    ///< with the stage; its stored results are named as those of the level of the file
  std::size_t stage = 0;  ///< number of the stage from 0: its own, or one after the first stage of the file
  StixRiver river;        ///< of the file
  Sentence sentence;      ///< what was moved, from where to where, and by which rule
};

/// A first stage stays as history, and one with the river follows it; of a later stage the water is another one.
/// level: [m]. Throws InputError where the side of the river is not known, or no ground is as high as the level
/// or all of it is higher.
RiverLevel with_river_level(
    const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis, Real level);

}  // namespace terp
