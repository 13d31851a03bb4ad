#include "input/printable.hpp"

#include "base/utf8.hpp"

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
