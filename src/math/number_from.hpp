// A text that is a number, in the form of C++ and JSON, with nothing before or after it.
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string_view>
#include <system_error>

namespace terp {

#ifdef __cpp_lib_to_chars
using std::from_chars;
#else  // libc++ before 20 has none for reals
std::from_chars_result from_chars(const char* first, const char* last, double& value);
template <std::integral Number>
std::from_chars_result from_chars(const char* first, const char* last, Number& value, int base = 10)
{
  return std::from_chars(first, last, value, base);
}
#endif

/// None: it is not one, or it is out of range.
template <class Number>
std::optional<Number> number_from(std::string_view text)
{
  Number value{};
  const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace terp
