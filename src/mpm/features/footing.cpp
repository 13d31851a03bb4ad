#include "mpm/features/footing.hpp"

#include <cmath>
#include <numbers>

namespace terp {

Vec<2> Footing::displacement(Real time) const
{
  Real duration = time - 0.5 * ramp;  // at full velocity this gives the same displacement
  if (time < ramp) duration = 0.5 * (time - ramp / std::numbers::pi * std::sin(std::numbers::pi * time / ramp));
  return {velocity[0] * duration + 0.0, velocity[1] * duration + 0.0};  // never -0
}

PlacedFooting place_footing(const Footing& footing, Real time, Real dt, Real slack)
{
  const Vec<2> before = footing.displacement(time), after = footing.displacement(time + dt);
  const Real speed = std::hypot(footing.velocity[0], footing.velocity[1]);
  PlacedFooting placed;
  for (int d = 0; d < 2; ++d) {
    placed.low[d] = footing.low[d] + before[d] - slack;
    placed.high[d] = footing.high[d] + before[d] + slack;
    placed.velocity[d] = (after[d] - before[d]) / dt;
    if (!footing.rough) placed.along[d] = footing.velocity[d] / speed;
  }
  return placed;
}

}  // namespace terp
