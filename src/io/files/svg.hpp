// Small parts of drawings that are written as SVG.
#pragma once

#include "math/types.hpp"

#include <string>
#include <string_view>

namespace terp {

/// Text that may stand between tags or in an attribute: without control characters but line ends, with <, >, & and " as
/// entities.
std::string escaped_for_markup(std::string_view text);

/// A step of 1, 2 or 5 times a power of ten that divides a range into about n parts.
Real nice_step(Real range, Real n);

}  // namespace terp
