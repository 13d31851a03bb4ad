// What all stages of a run are made from.
#pragma once

#include "model/parts/model.hpp"

namespace terp {

inline constexpr std::int64_t most_steps = 1'000'000'000;  ///< beyond: a time step that has collapsed, not a case

/// Throws InputError with the key of the case that is at fault.
std::shared_ptr<const Parts> parts_of(const Case& whole, const SharedMesh& mesh);

/// Steps to an end [s]; the tolerance is round-off of an end that is a whole number of steps.
Real steps_to(Real end, Real step);

}  // namespace terp
