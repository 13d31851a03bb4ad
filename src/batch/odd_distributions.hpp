// What of the distributions of a study is hardly meant: a spread in another unit, bounds or levels beside the values.
#pragma once

#include "batch/study.hpp"

namespace terp {

void doubt_distributions(const Study& study, std::vector<Problem>& doubts);

}  // namespace terp
