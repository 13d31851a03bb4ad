// UTF-8 texts (RFC 3629). Not for: what a terminal may show (input/printable.hpp).
#pragma once

#include <string>
#include <string_view>

namespace terp {

/// Bytes of the UTF-8 character that `text` starts with; 0 if it starts with none. The text is not empty.
std::size_t utf8_length(std::string_view text);

/// The text with U+FFFD in place of every byte that is not UTF-8.
std::string as_utf8(std::string_view text);

/// The character of a number below 0x10000 that is no half of a pair.
std::string utf8_of(unsigned number);

}  // namespace terp
