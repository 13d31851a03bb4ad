// A load on the surface of the soil: a pressure on the stretch that it began on, which the material points of that
// stretch carry from then on. Not for: which points (model/loads/loads), nor the force on nodes
// (mpm/kernels/map_load.hpp).
#pragma once

#include "math/types.hpp"

#include <functional>
#include <string>

namespace terp {

/// A force per mass [m/s^2] by the place [m], the first place of the point [m] and the time [s].
using BodyForce = std::function<Vec<2>(Vec<2> x, Vec<2> x_initial, Real time)>;

struct Load {
  std::string name;
  Real from = 0.0, to = 0.0;  ///< x of the ends of the stretch [m]
  Real pressure = 0.0;        ///< in full [Pa]
  Real start = 0.0;           ///< [s]; -infinity: it was always there
  Real end = 0.0;             ///< from which on it falls [s]; infinity: it stays
  Real ramp = 0.0;            ///< time over which it grows and falls [s]
  Real before = 0.0;          ///< pressure before the ramp of the stage [Pa]
  int row = -1;               ///< of the points: the part of the stretch that each carries [m]

  /// Always there: it acts in the search for equilibrium, too.
  bool is_permanent() const;
  /// Pressure at a time [Pa]: linear in it during the ramps. share: of the way from `before` to `pressure`.
  Real pressure_at(Real time, Real share = 1.0) const;
  /// The step at whose beginning it takes its place, counted from a time [s]; -1: before all times.
  std::int64_t first_step(Real dt, Real from = 0.0) const;
};

}  // namespace terp
