// The C++ library of mingw reads the letters of a path by mbrtowc() of the C library, which knows no UTF-8 on Windows.
// The linker puts this one in its place (--wrap in CMakeLists.txt). The other way round the library writes UTF-8.

#include "math/utf8.hpp"

#include <cstddef>
#include <cstdint>
#include <cwchar>

constexpr std::uint32_t replacement = 0xFFFD, first_of_two = 0x10000;

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
  std::string_view rest(from, n);
  const terp::Letter letter = terp::take_letter(rest);
  const std::uint32_t code = letter.code == terp::Letter::none ? replacement : letter.code;  // such a file is not found
  if (code < first_of_two) {
    unit = static_cast<wchar_t>(code);
    return code == 0 ? 0 : letter.bytes.size();
  }
  unit = static_cast<wchar_t>(0xD800 + ((code - first_of_two) >> 10));
  kept = static_cast<std::mbstate_t>(0xDC00 + (code & 0x3FF));
  return 3;
}
