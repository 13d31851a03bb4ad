// How much soil has moved away from where it began. Definition: docs/formats.md.
#pragma once

#include "points/point_blocks.hpp"

#include <span>

namespace terp {

/// Volume of the points that lie farther than `distance` [m] from their first places [m^2]. x_initial: by id, shape [n_points, 2] [m].
Real moved_volume(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance);

}  // namespace terp
