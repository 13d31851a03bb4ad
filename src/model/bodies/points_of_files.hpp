// Whether points from files have the room where they lie to themselves: a table of points may say anything.
// Not for: reading it (points_csv), nor which cell holds a point (setup_points).
#pragma once

#include "model/bodies/setup_points.hpp"

namespace terp {

/// Throws InputError, with the lines of the files, where two points lie at one place, where a point of a file lies in a
/// body that is drawn, and where points hold more volume than there is room. outlines: outlines_of the model. Without
/// a file nothing is done.
void check_points_of_files(const StageSoil& soil, const std::vector<BodyOutline>& outlines, const PointBatches& points);

}  // namespace terp
