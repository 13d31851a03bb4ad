// Laws of libraries beside what the case says of them.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

/// Strains a point of each soil of a library by small increments and compares the answer with its `shear_modulus` and
/// `poisson_ratio`. Throws InputError where the law is so much stiffer that the time step is unstable, and where it
/// reads beyond its arrays (model/libraries/short_arrays.hpp). A law that fails is left out: its run stops.
void find_odd_libraries(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
