// What the outcome of a case turns on: inputs are changed one at a time, by as much as they are rarely known better.
// Not for: how the runs are solved (converge.cpp).
#pragma once

#include "cli/converge_plan.hpp"
#include "io/results/depends.hpp"

#include <vector>

namespace terp {

struct Levers {
  std::vector<StudySequence> sequences;  ///< each with its input
  std::vector<std::string> not_varied;   ///< inputs for which there is none, with the reason
};

/// One input, less or more than given, in all soils that have it.
Levers levers_of(const ConvergeOptions& options);

/// Throws CaseError where a plan has but the case as given.
void refuse_if_nothing_decides(const ConvergeOptions& options, const Plan& plan);

/// What a message of a case says first.
std::string first_line_of(const std::string& error);

/// What came out of the runs of a plan.
Decision decide(const Plan& plan);

}  // namespace terp
