// What a drawing hardly means: a side that lies elsewhere than its name says, a gap between bodies, a body that hangs
// in the air, soil that falls outside of the mesh, a mesh in another unit than the bodies. Not for: what cannot be used
// at all (setup_points, mesh/check_mesh).
#pragma once

#include "base/errors.hpp"
#include "simulation/model.hpp"

#include <vector>

namespace terp {

/// Adds what is odd in the section. The points of the model are seeded: model.bodies is filled.
void find_odd_places(const Model& model, std::vector<Problem>& warnings);

}  // namespace terp
