// The fields of the points (frame_fields.hpp), gathered from the blocks and sorted by id.
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/observer.hpp"
#include "run/loop/state.hpp"

#include <optional>

namespace terp {

/// All points as they are now, with the fields that the case asks for (all if it names none).
Frame make_frame(const Model& model, const State& state);
/// Those with ids from `first` on, n of them.
Frame make_frame(const Model& model, const State& state, std::int64_t first, std::int64_t n);

/// One field of all points, or "position": shape [n_points, 2]; none if there is no such field. names: those that there
/// are.
std::optional<PointField> make_field(
    const Model& model, const State& state, const std::string& name, std::vector<std::string>& names);

}  // namespace terp
