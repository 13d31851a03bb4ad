// How much of the ground that moved came from deep below the first ground, and how much ravelled above that.
// Not for: how far soil must go to count as moved (model/ground/section.hpp).
#pragma once

#include "model/ground/section.hpp"
#include "mpm/points/ground.hpp"

#include <algorithm>
#include <span>

namespace terp {

struct MovedByDepth {
  Real deep_left = 0.0, deep_right = 0.0;  ///< volume that came from deeper, by the direction in which it went [m^2]
  Real ravelled = 0.0;                     ///< volume of the rest [m^2]
  Real ravelled_depth = 0.0;               ///< of it the deepest first place below the first ground [m]

  Real deep() const { return deep_left + deep_right; }
  Real deep(Facing facing) const { return facing == Facing::left ? deep_left : deep_right; }
};

/// Of the ground that lies farther than `distance` from its first place. first: the section that places count from;
/// x_initial: by id, shape [n_points, 2]; least_depth: below its surface [m].
MovedByDepth moved_by_depth(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance,
    const Section& first, Ground ground, Real least_depth);

/// Of deep soil as much as counts: a cell, as a single point may go astray [m^2].
inline Real least_deep_volume(const Section& first) { return first.columns.width * first.columns.width; }

}  // namespace terp
