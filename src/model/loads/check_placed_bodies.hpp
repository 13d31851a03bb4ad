// Before a run: whether there is room for the bodies that its stages place. Not for: placing them (placed_bodies).
#pragma once

#include "model/bodies/setup_points.hpp"

namespace terp {

/// Gives the points their row `held`: 1 for those of a body that the present stage places, -1 for those of one that it
/// digs away, else 0.
int add_held_row(RowTable& rows);

/// Throws InputError where a body is to be placed in soil that is drawn there, or has a velocity. points: all.
void check_placed_bodies(const Model& model, const PointBatches& points);

}  // namespace terp
