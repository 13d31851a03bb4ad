// The first byte gives the length of a letter, or says that none begins there. Then the rest is tested: following
// bytes, overlong forms, halves of pairs, the end of Unicode. Of what is faulty only the first byte is taken off, so
// that a sound letter right after it is still found.

#include "math/utf8.hpp"

#include <algorithm>

namespace terp {

Letter take_letter(std::string_view& text)
{
  const auto byte = [&](std::size_t k) -> std::uint32_t { return static_cast<unsigned char>(text[k]); };
  std::size_t n = byte(0) < 0x80   ? 1
                  : byte(0) < 0xC2 ? 0
                  : byte(0) < 0xE0 ? 2
                  : byte(0) < 0xF0 ? 3
                  : byte(0) < 0xF5 ? 4
                                   : 0;
  if (n > text.size()) n = 0;
  std::uint32_t code = n <= 1 ? byte(0) : byte(0) & (0x7Fu >> n);
  for (std::size_t k = 1; k < n; ++k) {
    if (byte(k) >> 6 != 2)
      n = 0;
    else
      code = code << 6 | (byte(k) & 0x3F);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};  // by number of bytes: less is overlong
  const bool is_half_of_pair = code >= 0xD800 && code < 0xE000;
  if (n == 0 || code < least[n] || is_half_of_pair || code > 0x10FFFF) n = 0;
  const Letter letter{n == 0 ? Letter::none : code, text.substr(0, std::max<std::size_t>(n, 1))};
  text.remove_prefix(letter.bytes.size());
  return letter;
}

std::string as_utf8(std::string_view text)
{
  std::string sound;
  while (!text.empty()) {
    const Letter letter = take_letter(text);
    sound += letter.code == Letter::none ? std::string_view("\xEF\xBF\xBD") : letter.bytes;
  }
  return sound;
}

std::string utf8_of(std::uint32_t code)
{
  if (code < 0x80) return {static_cast<char>(code)};
  const int n_more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  std::string letter(1, static_cast<char>((0xF00u >> (n_more + 1) & 0xFF) | code >> (6 * n_more)));
  for (int k = n_more; k-- > 0;) letter += static_cast<char>(0x80 | (code >> (6 * k) & 0x3F));
  return letter;
}

std::size_t count_letters(std::string_view text)
{
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

}  // namespace terp
