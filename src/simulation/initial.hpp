// The stress with which a run starts (reading R14).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

/// InitialStress::k0: sigma_yy = weight of the soil above, sigma_xx = sigma_zz = k0 sigma_yy. None: zero.
void set_initial_stress(const Model& model, State& state);

/// InitialStress::equilibrium: steps with strong local damping until the out-of-balance ratio is below the limit; then
/// displacement, velocity, strain and history are reset and the clock is set to zero. Throws RunError if the limit is not met.
void seek_equilibrium(const Model& model, State& state, Workspace& work);

}  // namespace terp
