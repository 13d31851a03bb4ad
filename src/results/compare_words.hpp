// What differs between runs, in words.
// Not for: the numbers (compare).
#pragma once

#include "results/compare.hpp"

namespace terp {

/// Sentences; the first run against each of the others. comparison: its rows.
std::vector<std::string> describe_differences(const std::vector<RunResults>& runs, const Comparison& comparison);

}  // namespace terp
