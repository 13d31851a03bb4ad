// Text of unknown origin as a terminal may show it.
#pragma once

#include <string>
#include <string_view>

namespace terp {

/// The text with a question mark for every control character but tab and line feed, and for every byte that is not
/// UTF-8.
std::string printable(std::string_view text);

}  // namespace terp
