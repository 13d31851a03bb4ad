// std::strtod reads more forms than std::from_chars: a sign, spaces and numbers of base 16.
#include "math/number_from.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>

namespace terp {

std::from_chars_result from_chars(const char* first, const char* last, double& value)
{
  const char* const begin = first != last && *first == '-' ? first + 1 : first;
  constexpr std::string_view letters = "0123456789.eE+-infatyINFATY";
  const char* const end = std::find_if(begin, last, [&](char c) { return letters.find(c) == letters.npos; });
  if (begin == end || *begin == '+' || *begin == '-') return {first, std::errc::invalid_argument};
  const std::string text(begin, end);
  char* stop = nullptr;
  errno = 0;
  const double read = std::strtod(text.c_str(), &stop);
  const char* const at = begin + (stop - text.c_str());
  if (at == begin) return {first, std::errc::invalid_argument};
  if (errno == ERANGE) return {at, std::errc::result_out_of_range};
  value = begin == first ? read : -read;
  return {at, std::errc{}};
}

}  // namespace terp
