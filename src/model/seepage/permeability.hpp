// What the water in a soil depends on.
#pragma once

#include "math/types.hpp"

namespace terp {

/// Permeability of a soil along and across its layers [m/s].
struct Permeability {
  Real horizontal = 0.0, vertical = 0.0;

  bool is_given() const { return horizontal != 0.0; }
  Vec<2> times(Vec<2> g) const { return {horizontal * g[0], vertical * g[1]}; }
  bool operator==(const Permeability&) const = default;
};

/// What the water of a soil fills and gives back.
struct Storage {
  Real yield = 0.2;     ///< volume per volume of soil that drains where the table falls [-]
  Real elastic = 1e-4;  ///< volume per volume of soil and metre of head [1/m]
};

}  // namespace terp
