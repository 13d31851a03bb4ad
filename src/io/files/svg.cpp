#include "io/files/svg.hpp"

#include <cmath>

namespace terp {

std::string escaped_for_markup(std::string_view text)
{
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f))
      out += c;
  }
  return out;
}

Real nice_step(Real range, Real n)
{
  const Real rough = range / n, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const Real factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10.0 * power;
}

}  // namespace terp
