// The state as named arrays, as checkpoints hold it, and back.
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/observer.hpp"
#include "run/loop/state.hpp"

#include <functional>

namespace terp {

/// Points in the fixed order of cells, blocks and lanes, so that a restored run adds in the same order: the same bits.
StateImage make_image(const State& state);

/// The same in parts of at most so many values, or of one row. Calls f with each, in order.
void for_each_part(const State& state, std::int64_t most_values, const std::function<void(StateImage)>& f);

/// Values in a part as a run shows it: all, or some MB where there are many points.
std::int64_t most_values_of_part(const State& state);

/// Material points with which the run of an image began. Throws FileError if it does not say.
std::int64_t count_points(const StateImage& image);

/// Throws FileError if the image does not fit the model.
State restore(const Model& model, const StateImage& image);

}  // namespace terp
