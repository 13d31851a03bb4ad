#include "io/case/printable.hpp"

#include "math/utf8.hpp"

namespace terp {

std::string printable(std::string_view text)
{
  const auto is_control = [](std::uint32_t code) {
    return (code < 0x20 && code != '\t' && code != '\n') || (code >= 0x7F && code < 0xA0);
  };
  std::string shown;
  while (!text.empty()) {
    const Letter letter = take_letter(text);
    shown += letter.code == Letter::none || is_control(letter.code) ? "?" : letter.bytes;
  }
  return shown;
}

}  // namespace terp
