// How much of the weight of bodies that come or go is held in a step. Not for: its force (map_held_weight.hpp).
#pragma once

#include "math/types.hpp"

namespace terp {

/// Part of the weight that is held, of bodies that are placed and of those that are dug away.
struct HeldShares {
  Real placed = 0.0, removed = 0.0;

  bool act() const { return placed != 0.0 || removed != 0.0; }
};

}  // namespace terp
