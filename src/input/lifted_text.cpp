#include "input/lifted_text.hpp"

#include <cstdint>

namespace terp {
namespace {

constexpr std::uint32_t lifted_by = 0xF0000, first_letter = 0x80, last_letter = 0xFFFF;

/// A letter and its number of bytes; 1 byte and its value for what is no UTF-8.
struct Letter {
  std::uint32_t code;
  std::size_t n_bytes;
  bool is_whole;
};

Letter letter_at(std::string_view text, std::size_t at)
{
  const auto byte = [&](std::size_t k) -> std::uint32_t { return static_cast<unsigned char>(text[k]); };
  const std::uint32_t lead = byte(at);
  const std::size_t n = lead < 0x80 ? 1 : lead >> 5 == 0x6 ? 2 : lead >> 4 == 0xE ? 3 : lead >> 3 == 0x1E ? 4 : 0;
  if (n == 0 || at + n > text.size()) return {lead, 1, false};
  std::uint32_t code = n == 1 ? lead : lead & (0x7Fu >> n);
  for (std::size_t k = 1; k < n; ++k) {
    if (byte(at + k) >> 6 != 2) return {lead, 1, false};
    code = code << 6 | (byte(at + k) & 0x3F);
  }
  return {code, n, true};
}

void append(std::uint32_t code, std::string& text)
{
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto add_rest = [&](int shift) { add(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x800) {
    add(0xC0 | code >> 6);
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add_rest(6);
  } else {
    add(0xF0 | code >> 18);
    add_rest(12);
    add_rest(6);
  }
  add_rest(0);
}

bool is_lifted(const Letter& letter)
{
  return letter.is_whole && letter.code >= first_letter + lifted_by && letter.code <= last_letter + lifted_by;
}

}  // namespace

std::string lift(std::string_view text)
{
  std::string lifted;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    const bool is_mark = at == 0 && letter.code == 0xFEFF;
    if (letter.is_whole && letter.code >= first_letter && letter.code <= last_letter && !is_mark)
      append(letter.code + lifted_by, lifted);
    else
      lifted += text.substr(at, letter.n_bytes);
    at += letter.n_bytes;
  }
  return lifted;
}

std::size_t find_lifted(std::string_view text)
{
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    if (is_lifted(letter)) return at;
    at += letter.n_bytes;
  }
  return std::string_view::npos;
}

std::string lower(std::string_view text)
{
  std::string lowered;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    if (is_lifted(letter))
      append(letter.code - lifted_by, lowered);
    else
      lowered += text.substr(at, letter.n_bytes);
    at += letter.n_bytes;
  }
  return lowered;
}

}  // namespace terp
