// Whether what a verdict says of ground that has failed has stopped changing (docs/stages.md, "With the verdict").
// Not for: soil that holds, which must be at rest (run/loop/stages).
#pragma once

#include "math/types.hpp"

#include <vector>

namespace terp {

/// What is left of the ground.
struct GroundLeft {
  Real height = 0.0;  ///< of the barrier [m]; minus infinity: none is left
  Real width = 0.0;   ///< at the water level [m]
  Real moved = 0.0;   ///< volume that moved [m^2]
};

/// How well the numbers are known on cells of this width: the height as measured (docs/flood.md), the width as that of
/// a scarp that rises by one in three, the volume within a hundredth or a cell.
GroundLeft resolution_of(const GroundLeft& ground, Real cell_width);

/// The ground at the last looks, of which RestMarks::n are a swing of the soil.
class SettledGround {
 public:
  void forget() { looks_.clear(); }

  /// True: no number has changed by its resolution since a swing ago. A look that lies between two others is asked,
  /// too, so a height that falls in steps settles only once a whole swing passes without one.
  bool enter(const GroundLeft& ground, const GroundLeft& resolution);

  std::vector<Real> values() const;
  void set_values(const std::vector<Real>& values);

 private:
  std::vector<GroundLeft> looks_;  // the oldest first
};

}  // namespace terp
