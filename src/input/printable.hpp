// Text of unknown origin as a terminal may show it.
#pragma once

#include <string>
#include <string_view>

namespace terp {

/// Bytes of the UTF-8 character that `text` starts with; 0 if it starts with none (RFC 3629). The text is not empty.
std::size_t utf8_length(std::string_view text);

/// The text with a question mark for every control character but tab and line feed, and for every byte that is not
/// UTF-8.
std::string printable(std::string_view text);

}  // namespace terp
