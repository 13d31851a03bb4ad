// A rigid footing: a box that moves with a prescribed velocity and prescribes that of the nodes inside it. Not for: its
// reaction (model/loads/footings), nor sides of the mesh (conditions.hpp).
#pragma once

#include "mpm/mesh/mesh.hpp"

#include <string>

namespace terp {

inline constexpr std::size_t most_footings = 8;  ///< of one case

struct Footing {
  std::string name;
  Vec<2> low{0.0, 0.0}, high{0.0, 0.0};  ///< corners of the box at t = 0 [m]
  Vec<2> velocity{0.0, 0.0};             ///< after the ramp [m/s]
  Real ramp = 0.0;                       ///< time over which the velocity grows from zero [s]
  bool rough = true;                     ///< rough: both components of the nodes; smooth: the one along the velocity

  /// Displacement of the footing at a time [m]: v(t) = V (1 - cos(pi t/T))/2 during the ramp T, then V.
  Vec<2> displacement(Real time) const;
};

/// A footing during one step.
struct PlacedFooting {
  Vec<2> low{0.0, 0.0}, high{0.0, 0.0};  ///< at the start of the step, widened by round-off [m]
  Vec<2> velocity{0.0, 0.0};             ///< mean over the step [m/s]
  Vec<2> along{0.0, 0.0};                ///< smooth: direction of motion, unit; rough: zero

  bool holds(Vec<2> x) const { return x[0] >= low[0] && x[0] <= high[0] && x[1] >= low[1] && x[1] <= high[1]; }

  /// Gives the velocity of a node inside its prescribed components [m/s].
  void hold(Vec<2>& v) const
  {
    const Real missing = (velocity[0] - v[0]) * along[0] + (velocity[1] - v[1]) * along[1];
    const bool rough = along == Vec<2>{0.0, 0.0};
    v = rough ? velocity : Vec<2>{v[0] + missing * along[0], v[1] + missing * along[1]};
  }
  /// The part of a force or velocity of a node inside that the footing does not prescribe.
  Vec<2> free_part(Vec<2> value) const
  {
    if (along == Vec<2>{0.0, 0.0}) return {0.0, 0.0};
    const Real taken = value[0] * along[0] + value[1] * along[1];
    return {value[0] - taken * along[0], value[1] - taken * along[1]};
  }
};

/// By how much the box of a footing is widened, so that nodes on its outline belong to it [m].
inline Real outline_slack(const Mesh<2>& mesh) { return 1e-6 * mesh.smallest_altitude; }

/// The footing in the step from `time` to `time + dt`; slack: by which a node on its outline may lie outside [m].
PlacedFooting place_footing(const Footing& footing, Real time, Real dt, Real slack);

}  // namespace terp
