// The C++ library of mingw reads the letters of a path by mbrtowc() of the C library, which knows no UTF-8 on Windows.
// The linker puts this one in its place (--wrap in CMakeLists.txt). The other way round the library writes UTF-8.

#include <cstddef>
#include <cstdint>
#include <cwchar>

namespace {

constexpr std::uint32_t replacement = 0xFFFD, first_of_two = 0x10000;

struct Letter {
  std::uint32_t code;
  int n_bytes;
};

/// What is no UTF-8 is one byte that stands for U+FFFD: such a file is not found.
Letter letter_at(const unsigned char* text, std::size_t n)
{
  const unsigned first = text[0];
  const int n_bytes = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (n_bytes == 0 || static_cast<std::size_t>(n_bytes) > n) return {replacement, 1};
  constexpr unsigned bits_of_first[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
  std::uint32_t code = first & bits_of_first[n_bytes];
  for (int k = 1; k < n_bytes; ++k) {
    if ((text[k] & 0xC0) != 0x80) return {replacement, 1};
    code = code << 6 | (text[k] & 0x3F);
  }
  const bool too_long = (n_bytes == 3 && code < 0x800) || (n_bytes == 4 && code < first_of_two);
  return too_long || code > 0x10FFFF || code >> 11 == 0x1B ? Letter{replacement, 1} : Letter{code, n_bytes};
}

}  // namespace

/// Of a letter that takes two wide ones the first three bytes give the one, the fourth the other, kept in `state`.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t n, std::mbstate_t* state)
{
  static std::mbstate_t own = 0;
  std::mbstate_t& kept = state == nullptr ? own : *state;
  if (from == nullptr) return kept = 0;
  if (n == 0) return static_cast<std::size_t>(-2);
  wchar_t ignored;
  wchar_t& unit = to == nullptr ? ignored : *to;
  if (kept != 0) {
    unit = static_cast<wchar_t>(kept);
    kept = 0;
    return 1;
  }
  const Letter letter = letter_at(reinterpret_cast<const unsigned char*>(from), n);
  if (letter.code < first_of_two) {
    unit = static_cast<wchar_t>(letter.code);
    return letter.code == 0 ? 0 : static_cast<std::size_t>(letter.n_bytes);
  }
  unit = static_cast<wchar_t>(0xD800 + ((letter.code - first_of_two) >> 10));
  kept = static_cast<std::mbstate_t>(0xDC00 + (letter.code & 0x3FF));
  return 3;
}
