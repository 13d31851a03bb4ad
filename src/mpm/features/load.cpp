#include "mpm/features/load.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

bool Load::is_permanent() const { return std::isinf(start); }

Real Load::pressure_at(Real time, Real share) const
{
  const auto share_since = [&](Real begin) {
    if (time < begin) return 0.0;
    return ramp > 0.0 ? std::min(1.0, (time - begin) / ramp) : 1.0;
  };
  const Real grown = is_permanent() ? 1.0 : share_since(start), fallen = std::isinf(end) ? 0.0 : share_since(end);
  const Real in_full = share < 1.0 ? before + share * (pressure - before) : pressure;
  return in_full * std::max(0.0, grown - fallen);
}

std::int64_t Load::first_step(Real dt, Real from) const
{
  constexpr Real round_off = 1e-9;  // of a step
  return is_permanent() ? -1 : static_cast<std::int64_t>(std::floor((start - from) / dt + round_off));
}

}  // namespace terp
