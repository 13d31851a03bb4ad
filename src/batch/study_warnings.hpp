// What `terp check` would warn of in the cases that a study makes, before it makes them.
// Not for: what is doubtful in the study file itself (find_doubts, study.hpp).
#pragma once

#include "batch/study.hpp"

#include <vector>

namespace terp {

struct WarningsOfCases {
  std::vector<Problem> base;   ///< of the case as it is without any draw, at its keys
  std::vector<Problem> drawn;  ///< of draws alone, at the keys of the study file
};

/// Each message once. doubts: what is said of the study file anyway.
WarningsOfCases find_warnings_of_cases(const Study& study, const std::vector<Problem>& doubts);

}  // namespace terp
