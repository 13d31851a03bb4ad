#include "drawing/dxf_letters.hpp"

#include "base/utf8.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace terp {
namespace {

/// Numbers of the bytes 0x80 to 0x9F of code page 1252; from 0xA0 on a byte is its own number. 0xFFFD: none.
constexpr std::array<unsigned, 32> page_1252{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6,
    0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013,
    0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

/// The number of \U+XXXX at the start of a text; 0: none is there.
unsigned escaped_number(std::string_view text)
{
  unsigned number = 0;
  if (text.size() < 7 || !text.starts_with("\\U+")) return 0;
  const auto [end, error] = std::from_chars(text.data() + 3, text.data() + 7, number, 16);
  const bool is_half_of_pair = number >= 0xD800 && number < 0xE000;
  return error == std::errc() && end == text.data() + 7 && !is_half_of_pair ? number : 0;
}

bool is_utf8(std::string_view text)
{
  for (std::size_t length = 0; !text.empty(); text.remove_prefix(length))
    if ((length = utf8_length(text)) == 0) return false;
  return true;
}

}  // namespace

std::string dxf_letters(std::string_view text, std::string_view code_page)
{
  const bool is_known = code_page.empty() || code_page == "ANSI_1252", is_sound = is_utf8(text);
  std::string letters;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (const unsigned number = escaped_number(text.substr(k)); number != 0) {
      letters += utf8_of(number);
      k += 6;
    } else if (byte < 0x80 || is_sound) {
      letters += text[k];
    } else {
      letters += utf8_of(!is_known ? 0xFFFD : byte < 0xA0 ? page_1252[byte - 0x80] : byte);
    }
  }
  return letters;
}

}  // namespace terp
