// A field of all points in memory: read by the name that it has in results, and set.
#pragma once

#include "simulation/model.hpp"
#include "simulation/observer.hpp"
#include "simulation/state.hpp"

namespace terp {

/// See Simulation::field.
PointField get_point_field(const Model& model, const State& state, const std::string& name);

/// See Simulation::set_field.
void set_point_field(const Model& model, const std::string& name, const std::vector<Real>& values, State& state);

}  // namespace terp
