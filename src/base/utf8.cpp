#include "base/utf8.hpp"

#include <algorithm>

namespace terp {

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

std::string as_utf8(std::string_view text)
{
  std::string sound;
  sound.reserve(text.size());
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t length = utf8_length(text.substr(k));
    sound += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(k, length);
    k += std::max<std::size_t>(length, 1);
  }
  return sound;
}

std::string utf8_of(unsigned number)
{
  const auto byte = [](unsigned bits) { return static_cast<char>(bits); };
  if (number < 0x80) return {byte(number)};
  if (number < 0x800) return {byte(0xC0 | number >> 6), byte(0x80 | (number & 0x3F))};
  return {byte(0xE0 | number >> 12), byte(0x80 | (number >> 6 & 0x3F)), byte(0x80 | (number & 0x3F))};
}

}  // namespace terp
