// Laws of libraries beside what the case says of them.
#pragma once

#include "base/errors.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

#include <vector>

namespace terp {

/// Strains a point of each soil of a library by small increments and compares the answer with its `shear_modulus` and
/// `poisson_ratio`. Throws InputError where the law is so much stiffer that the time step is unstable, and where it
/// reads beyond its arrays (user_laws/short_arrays.hpp). A law that fails is left out: its run stops.
void find_odd_libraries(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
