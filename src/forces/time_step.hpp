// The stable time step, reading R19.
#pragma once

#include "base/types.hpp"

#include <cmath>

namespace terp {

/// Speed of compression waves [m/s] from K + 4G/3 [Pa] and density [kg/m^3].
inline Real wave_speed(Real p_wave_modulus, Real density) { return std::sqrt(p_wave_modulus / density); }

/// C min(L_e) / c_p [s].
inline Real stable_time_step(Real courant, Real smallest_altitude, Real fastest_wave) { return courant * smallest_altitude / fastest_wave; }

}  // namespace terp
