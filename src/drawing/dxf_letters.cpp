#include "drawing/dxf_letters.hpp"

#include "base/utf8.hpp"
#include "drawing/code_pages.hpp"

#include <algorithm>
#include <charconv>

namespace terp {
namespace {

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
  const std::u16string_view page = letters_of_code_page(code_page.empty() ? "ANSI_1252" : code_page);
  const bool is_sound = is_utf8(text);
  std::string letters;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (const unsigned number = escaped_number(text.substr(k)); number != 0) {
      letters += utf8_of(number);
      k += 6;
    } else if (byte < 0x80 || is_sound) {
      letters += text[k];
    } else {
      letters += utf8_of(page.empty() ? 0xFFFD : page[byte - 0x80]);
    }
  }
  return letters;
}

}  // namespace terp
