#include "simulation/slip_planes.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {

std::string words_of(const SlipPlaneCase& plane)
{
  return plane.name + (plane.method.empty() ? "" : ", " + plane.method) +
         (std::isnan(plane.factor_of_safety) ? "" : fmt::format(", {:.3f}", plane.factor_of_safety));
}

}  // namespace terp
