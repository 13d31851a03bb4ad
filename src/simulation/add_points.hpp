// Seeded material points become points of the state: their rows filled, in blocks of the right size.
// Not for: where they are seeded (setup_points.hpp).
#pragma once

#include "simulation/setup_points.hpp"
#include "simulation/state.hpp"

#include <functional>

namespace terp {

/// Adds the points of the bodies for which `wanted` is true; ids count all points. Each batch is dropped when it is in:
/// points and blocks together would be the most that a run ever holds.
void add_points(
    const Model& model, PointBatches points, const std::function<bool(const BodyCase&)>& wanted, State& state);

}  // namespace terp
