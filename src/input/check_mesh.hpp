// What single keys of [mesh] cannot show: keys of different kinds of mesh, sides that do not meet, edges that are not
// there. Not for: the cells themselves (mesh).
#pragma once

#include "input/document.hpp"
#include "input/values.hpp"
#include "simulation/case.hpp"

namespace terp {

/// Adds what is wrong or doubtful about [mesh].
void check_mesh(const Node& root, const MeshCase& mesh, Findings& findings);

/// Turns the polygon of a mesh counter-clockwise; its edges keep their places and take their new numbers.
void turn_counter_clockwise(MeshCase& mesh);

}  // namespace terp
