#include "input/printable.hpp"

#include <algorithm>

namespace terp {
namespace {

bool is_control(std::string_view character)
{
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return (first < 0x20 && first != '\t' && first != '\n') || first == 0x7F;
  return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;  // U+0080 to U+009F
}

}  // namespace

std::size_t utf8_length(std::string_view text)
{
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const std::size_t length = byte(0) < 0x80   ? 1
                             : byte(0) < 0xC2 ? 0
                             : byte(0) < 0xE0 ? 2
                             : byte(0) < 0xF0 ? 3
                             : byte(0) < 0xF5 ? 4
                                              : 0;
  if (length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xC0) != 0x80) return 0;
  const bool overlong = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xF0 && byte(1) < 0x90);
  const bool beyond =
      (byte(0) == 0xED && byte(1) >= 0xA0) || (byte(0) == 0xF4 && byte(1) >= 0x90);  // surrogates; above U+10FFFF
  return overlong || beyond ? 0 : length;
}

std::string printable(std::string_view text)
{
  std::string shown;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t length = utf8_length(text.substr(k));
    const std::string_view character = text.substr(k, std::max<std::size_t>(length, 1));
    if (length == 0 || is_control(character))
      shown += '?';
    else
      shown += character;
    k += character.size();
  }
  return shown;
}

}  // namespace terp
