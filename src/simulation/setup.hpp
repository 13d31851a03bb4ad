// From a case to the model and its first state.
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace terp {

/// Throws InputError with the key of the case that is at fault.
Model build_model(const Case& description, int threads);

/// Seeds the points and sets the initial stress (none or k0; "equilibrium" is sought by the run). Throws InputError.
State build_state(Model& model);

/// The points that seeding gives, without making a state.
std::vector<Seed> seed_bodies(const Model& model);

}  // namespace terp
