// A series of river levels, as a measuring station gives them: from it follow the situations of the water in time.
// Not for: reading its table (io/case/level_keys.cpp).
#pragma once

#include "model/case/case.hpp"

#include <string>
#include <vector>

namespace terp {

/// "49 levels in 96 h, from 1 m to 4 m at 36 h; 1 h takes 1 s".
std::string describe(const LevelSeries& series);

/// The line of a level that the case does not give: the level as far as the ground lies below it, then straight to the
/// toe on the other side of the crest, and the lower of level and land beyond. Empty where bodies have no outlines.
std::vector<Vec<2>> line_of_level(const Case& c, Real level, RiverSide side);

/// Replaces the situations of the water by those of its series, if it has one: the first level is that of the start.
/// False: the case gives no line, and none follows from its bodies.
bool follow_series(Case& c);

}  // namespace terp
