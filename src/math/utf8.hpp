// UTF-8 texts (RFC 3629). Not for: what a terminal may show (io/case/printable.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace terp {

/// A letter of a text, or a byte that is not UTF-8.
struct Letter {
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  std::uint32_t code;  ///< its number in Unicode; none: a byte that is not UTF-8
  std::string_view bytes;
};

/// Takes the first letter off a text, which is not empty.
Letter take_letter(std::string_view& text);

/// The text with U+FFFD in place of every byte that is not UTF-8.
std::string as_utf8(std::string_view text);

/// The letter of a number that is no half of a pair.
std::string utf8_of(std::uint32_t code);

/// Letters of a text; bytes that are not UTF-8 do not count where they could be the rest of a letter.
std::size_t count_letters(std::string_view text);

/// Without the blanks, tabs and carriage returns at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace terp
