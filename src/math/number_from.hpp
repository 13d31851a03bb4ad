// A text that is a number, in the form of C++ and JSON, with nothing before or after it.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace terp {

/// None: it is not one, or it is out of range.
template <class Number>
std::optional<Number> number_from(std::string_view text)
{
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace terp
