// Damping of the out-of-balance force at a node (reading R13).
#pragma once

#include "math/types.hpp"

#include <cmath>

namespace terp {

struct Damping {
  Real local = 0.0;           ///< alpha [-]
  Real averaging_time = 0.0;  ///< of the force that local damping looks at; 0: that of the step [s]
  Real viscous = 0.0;         ///< mass-proportional coefficient [1/s]
  Vec<2> down{0.0, -1.0};     ///< direction of gravity, unit
};

/// Force that damping adds to one component of the out-of-balance force R of a node: local (Cundall) -alpha |M|
/// sign(v), with no force where v = 0, and viscous -c m v. M: R, or its running mean; v: before the update.
inline Real damping_force(const Damping& damping, Real mean_force, Real mass, Real v)
{
  const Real local = v == 0.0 ? 0.0 : -damping.local * std::copysign(std::abs(mean_force), v);
  return local - damping.viscous * mass * v;
}

/// The same for a vector, by its components along and across gravity: so it does not depend on the axes [N per m].
inline Vec<2> damping_force(const Damping& damping, Vec<2> mean_force, Real mass, Vec<2> v)
{
  const Vec<2> down = damping.down, across{-down[1], down[0]};
  const auto component = [&](Vec<2> e) {
    return damping_force(damping, mean_force[0] * e[0] + mean_force[1] * e[1], mass, v[0] * e[0] + v[1] * e[1]);
  };
  const Real along_down = component(down), along_across = component(across);
  return {along_down * down[0] + along_across * across[0], along_down * down[1] + along_across * across[1]};
}

/// Running mean of the out-of-balance force of a node over the averaging time, one step on [N per m] (decision 0043).
inline void follow_force(const Damping& damping, Vec<2> out_of_balance, Real dt, Vec<2>& mean)
{
  const Real weight = dt < damping.averaging_time ? dt / damping.averaging_time : 1.0;
  for (int d = 0; d < 2; ++d) mean[d] += weight * (out_of_balance[d] - mean[d]);
}

}  // namespace terp
