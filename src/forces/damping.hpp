// Damping of the out-of-balance force at a node (reading R13).
#pragma once

#include "base/types.hpp"

#include <cmath>

namespace terp {

struct Damping {
  Real local = 0.0;    ///< alpha [-]
  Real viscous = 0.0;  ///< mass-proportional coefficient [1/s]
};

/// Force that damping adds to the out-of-balance force R of a node, per component: local (Cundall) -alpha |R| sign(v), with
/// no force where v = 0, and viscous -c m v. v: before the update.
inline Real damping_force(const Damping& damping, Real out_of_balance, Real mass, Real v)
{
  const Real local = v == 0.0 ? 0.0 : -damping.local * std::copysign(std::abs(out_of_balance), v);
  return local - damping.viscous * mass * v;
}

}  // namespace terp
