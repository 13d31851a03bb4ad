// What can be run but is hardly meant: told before a run.
#pragma once

#include "base/errors.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

#include <vector>

namespace terp {

/// Named places far from the soil, bodies without points, points with little volume, sides that move further than their
/// cells reach. The state is that of t = 0.
std::vector<Problem> find_warnings(const Model& model, const State& state);

}  // namespace terp
