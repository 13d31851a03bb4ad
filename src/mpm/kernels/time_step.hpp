// The stable time step, reading R19.
#pragma once

#include "math/types.hpp"

#include <cmath>

namespace terp {

/// Speed of compression waves [m/s] from K + 4G/3 [Pa] and density [kg/m^3].
inline Real wave_speed(Real p_wave_modulus, Real density) { return std::sqrt(p_wave_modulus / density); }

/// C min(L_e) / c_p [s].
inline Real stable_time_step(Real courant, Real smallest_altitude, Real wave)
{
  return courant * smallest_altitude / wave;
}

/// By how much viscosity shortens the stable step: sqrt(1 + z^2) - z, where z = 4 nu / (3 c L) is the share of critical
/// damping that the shortest wave of the mesh gets from the kinematic viscosity nu [m^2/s]. Viscous forces are those of
/// the velocity half a step before: with frequency w = 2 c/L the amplification stays within one while w^2 dt^2 + 4 z w
/// dt <= 4.
inline Real viscous_reduction(Real kinematic_viscosity, Real smallest_altitude, Real wave)
{
  const Real z = 4.0 * kinematic_viscosity / (3.0 * wave * smallest_altitude);
  return 1.0 / (std::sqrt(1.0 + z * z) + z);
}

}  // namespace terp
