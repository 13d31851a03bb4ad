// Layers so thin against their cells that most of them lies in cells which they share with other soil.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

namespace terp {

/// Of each material the share of its volume that lies in cells with another material [-]; 0 of one without points.
std::vector<Real> shares_in_shared_cells(const Model& model, const State& state);

/// Layers that may yield and lie mostly in such cells: slip along them takes too much force.
void find_shared_layers(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
