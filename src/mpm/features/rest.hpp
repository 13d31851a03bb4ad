// The speed by which it is known that soil rests. Its slot is full while somebody looks at it.
// Not for: when soil is at rest (mpm/step/stage.hpp, run/loop/stages).
#pragma once

#include "math/types.hpp"

#include <limits>

namespace terp {

struct Workspace;

/// Least part of the mass of a full cell at a node that counts for rest: below it a single grain moves the node.
inline constexpr Real part_that_rests = 0.05;

struct RestScratch {
  Real fastest_node = std::numeric_limits<Real>::quiet_NaN();  ///< largest speed of a node that counts for rest [m/s]
};

/// Looks at the speed of the nodes from the next step on, or no more.
void watch_speed(bool watches, Workspace& work);

/// Largest speed of a node that counts for rest, in the last step [m/s]; NaN: nobody looks, or no step yet.
Real fastest_node(const Workspace& work);

}  // namespace terp
