// What can be run but is hardly meant: reported before a run, by `terp check` and `terp run`.
#pragma once

#include "base/errors.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

#include <vector>

namespace terp {

/// All warnings: named places far from the soil, bodies without points, points with little volume, sides that move
/// further than their cells reach, odd places (section_warnings.hpp), odd magnitudes (scale_warnings.hpp), idle
/// footings. The state is that of t = 0.
std::vector<Problem> find_warnings(const Model& model, const State& state);

}  // namespace terp
