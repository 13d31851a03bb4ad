// Slip planes of other methods that a case names, in words.
#pragma once

#include "simulation/case.hpp"

#include <string>

namespace terp {

/// "High Water, Bishop, 1.004", of what is given.
std::string words_of(const SlipPlaneCase& plane);

}  // namespace terp
