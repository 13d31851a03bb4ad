// The number that stands where there is none.
#pragma once

#include "math/types.hpp"

#include <limits>

namespace terp {

inline constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

}  // namespace terp
