// Laws of libraries beside what the case says of them.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

inline constexpr double limit_of_trial_s = 30.0;  ///< some 400 calls of some 10 microseconds as a rule

/// Strains a point of each soil of a library by small increments, in a copy of this process, and compares the answer
/// with its `shear_modulus` and `poisson_ratio`. Throws InputError where the law is so much stiffer that the time step
/// is unstable, where it reads beyond its arrays (model/libraries/short_arrays.hpp), and where the copy does not come
/// to an end. A law that returns no numbers is left out: its run stops.
void find_odd_libraries(
    const Model& model, const State& state, std::vector<Problem>& warnings, double limit_s = limit_of_trial_s);

}  // namespace terp
