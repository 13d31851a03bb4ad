// Warnings of parameters that vary: values that are given for other soil than there is, random fields in coarse cells.
// Not for: tables of a file, whose places are compared with the soil (model/soils/settle_fields).
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

void find_odd_fields(const Model& model, const State& state, std::vector<Problem>& warnings);

/// A random field on cells of a size [m], if they do not resolve it. key: of the field.
std::optional<Problem> find_coarse_cells(const std::string& key, const FieldScale& scale, Real cell);

}  // namespace terp
