// The state as named arrays, as checkpoints hold it, and back.
#pragma once

#include "simulation/model.hpp"
#include "simulation/observer.hpp"
#include "simulation/state.hpp"

namespace terp {

/// Points in the fixed order of cells, blocks and lanes, so that a restored run adds in the same order: the same bits.
StateImage make_image(const State& state);

/// Material points with which the run of an image began. Throws FileError if it does not say.
std::int64_t count_points(const StateImage& image);

/// Throws FileError if the image does not fit the model.
State restore(const Model& model, const StateImage& image);

}  // namespace terp
