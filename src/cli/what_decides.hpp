// What the outcome of a case turns on: inputs are changed one at a time, by as much as they are rarely known better.
// Not for: how the runs are solved (converge.cpp).
#pragma once

#include "cli/converge_plan.hpp"
#include "io/results/depends.hpp"

#include <vector>

namespace terp {

/// One input, less or more than given, in all soils that have it. Throws CaseError if the case has none of them.
std::vector<StudySequence> sequences_that_may_decide(const ConvergeOptions& options);

/// What came out of the runs of a plan.
Decision decide(const Plan& plan);

}  // namespace terp
