// The verdict on the water with the stage in which it came true.
// Not for: the verdict itself (flood_summary.hpp).
#pragma once

#include "simulation/summary.hpp"

#include <string>

namespace terp {

/// flood_clause() of a run with [flood], and in which stage the flood, or else the damage, began: "...; it began in the
/// stage `daily`, before `flood`". A clause, without the stop at its end.
std::string verdict_clause(const Summary& summary);

}  // namespace terp
