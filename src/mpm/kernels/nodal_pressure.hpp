// The pressure of the water on the nodes of the mesh in one step. Not for: its force (pore_pressure.hpp).
#pragma once

#include "math/types.hpp"

#include <vector>

namespace terp {

/// Water on the nodes of the mesh at the time of a step.
struct PorePressure {
  std::vector<Real> pressure;   ///< p, at least 0 [Pa], shape [n_nodes]
  std::vector<Real> unlimited;  ///< the same, negative above the water [Pa], shape [n_nodes]
  std::vector<Real> suction;    ///< s, at least 0 [Pa], shape [n_nodes]; empty: none anywhere
};

}  // namespace terp
