// Keys of a sweep that decide nothing: values that make the same case, and keys that do not act.
#pragma once

#include "batch/study.hpp"

#include <vector>

namespace terp {

/// Adds a problem for each key of which two values give the same case; a title and the places of checkpoints are no
/// part of it. Of a table whole rows may repeat. The mesh of the study must be there.
void refuse_idle_sweeps(const Study& study, std::vector<Problem>& problems);

/// Adds a doubt for each key that the case says has no effect, whatever its value.
void doubt_idle_sweeps(const Study& study, std::vector<Problem>& doubts);

}  // namespace terp
