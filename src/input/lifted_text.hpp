// Text as toml++ 3.3 can bear it: outside strings it runs into undefined behaviour at some letters between U+00A0 and
// U+FEFF (is_non_ascii_horizontal_whitespace), and what it takes for a string is known only to itself. So it never sees
// them. Not for: what is wrong with such a letter (document.cpp says it where it can).
#pragma once

#include <string>
#include <string_view>

namespace terp {

/// Moves the letters U+0080 to U+FFFF to U+F0080 to U+FFFFF, where Unicode has none of its own (plane 15, private use).
/// Each stays one letter, so columns stay. Bytes that are no UTF-8 and a byte order mark at the start are left as they
/// are.
std::string lift(std::string_view text);

/// Where `text` has a letter that `lift` uses, in bytes; npos: nowhere.
std::size_t find_lifted(std::string_view text);

/// Moves them back.
std::string lower(std::string_view text);

}  // namespace terp
