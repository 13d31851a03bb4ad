// The stress with which a run starts (reading R14).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <atomic>
#include <string>

namespace terp {

/// InitialStress::k0: sigma_yy = weight of the soil above, sigma_xx = sigma_zz = k0 sigma_yy. None: zero.
void set_initial_stress(const Model& model, State& state);

/// InitialStress::equilibrium: steps with strong local damping while the clock stands at 0, until the out-of-balance ratio is below
/// the limit; then displacement, velocity, strain and history are reset. Goes on where an interrupted search stopped.
/// Returns what went wrong, or nothing; nothing too when `stop` was set: then the clock is at 0 and the limit is not met yet.
std::string seek_equilibrium(const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop);

}  // namespace terp
