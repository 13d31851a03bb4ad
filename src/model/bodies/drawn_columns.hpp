// Which body is there from the ground down, at each x: many places are asked for what lies above them.
// Not for: soil that has moved (mpm/points/surface).
#pragma once

#include "model/bodies/body_outline.hpp"

#include <span>
#include <vector>

namespace terp {

/// What a vertical line meets on its way down.
struct DrawnLayer {
  Side top;  ///< a side of an outline
  int body;  ///< that is there below it; `DrawnColumns::nothing`: none
};

class DrawnColumns {
 public:
  static constexpr int nothing = -1;

  DrawnColumns() = default;
  /// Of bodies by their sides. Where bodies overlap, the last one is there.
  explicit DrawnColumns(const std::vector<std::vector<Side>>& bodies);

  /// From the highest soil at x down; the last one has nothing below it. Empty: no soil.
  std::span<const DrawnLayer> at(Real x) const;

 private:
  std::vector<Real> breaks_;         ///< x of all corners, and where sides cross [m]
  std::vector<std::size_t> starts_;  ///< of the layers from each break on, shape [n_breaks]; the last one has none
  std::vector<DrawnLayer> layers_;
};

}  // namespace terp
