// Keys of a study that set the same value of the case.
#pragma once

#include "study/study.hpp"

#include <vector>

namespace terp {

/// Adds a problem for each two keys of which the later one would undo the other: the same place under two names, a part
/// and its whole, a parameter and its ratio to another (su_residual and sensitivity).
void refuse_overlaps(const Study& study, std::vector<Problem>& problems);

}  // namespace terp
