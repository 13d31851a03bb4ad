// What a search for a factor of safety may be asked for.
#pragma once

#include "base/types.hpp"

namespace terp {

/// Least and greatest factor that is tried.
inline constexpr Real least_factor = 0.01, greatest_factor = 100.0;

/// Width of the bracket at which a search may end.
inline constexpr Real least_tolerance = 1e-4, greatest_tolerance = 1.0;

}  // namespace terp
