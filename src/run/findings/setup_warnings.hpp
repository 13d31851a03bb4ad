// What can be run but is hardly meant: reported before a run, by `terp check` and `terp run`.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

/// All warnings: named places far from the soil, bodies without points, points with little volume, sides that move
/// further than their cells reach, odd places, odd magnitudes, idle footings. The state is that of t = 0.
std::vector<Problem> find_warnings(const Model& model, const State& state);

void find_odd_scales(const Model& model, const State& state, std::vector<Problem>& warnings);

/// Odd places in the section: gaps, bodies in the air, now or once a stage has removed what carries them.
void find_odd_places(const Model& model, std::vector<Problem>& warnings);

}  // namespace terp
