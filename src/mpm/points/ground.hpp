// Which material points are ground: soil that a slope or a dike is made of. Not water that lies on it, nor what loads
// it. Not for: how high the ground stands (surface.hpp, barrier.hpp).
#pragma once

#include "mpm/points/point_blocks.hpp"

#include <cstdint>
#include <span>

namespace terp {

/// By number of the material: 1 of ground; empty: all points are.
using Ground = std::span<const std::uint8_t>;

inline bool is_ground(Ground ground, const PointBlock<2>& block)
{
  return ground.empty() || ground[static_cast<std::size_t>(block.material)] != 0;
}

}  // namespace terp
