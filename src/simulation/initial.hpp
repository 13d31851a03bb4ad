// The stress with which a run starts (reading R14).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <atomic>
#include <functional>
#include <string>

namespace terp {

/// InitialStress::k0: effective sigma_yy = weight of soil, free water and permanent loads above, as all of these are at
/// t = 0, less p_w, effective sigma_xx = sigma_zz = k0 sigma_yy; undrained soil stores them less p_w. None: zero.
/// With water the search for equilibrium begins with the same stress, where all bodies have outlines.
void set_initial_stress(const Model& model, State& state);

/// How the search for equilibrium ended; neither: it was stopped and goes on later.
struct Search {
  bool reached = false;
  std::string fault = {};  ///< what went wrong
};

/// InitialStress::equilibrium: steps with strong local damping while the clock stands at 0, until the out-of-balance
/// ratio is below the limit; then displacement, velocity, strain and history are reset. Goes on where an interrupted
/// search stopped. A body of which more than 1 % yielded and moved beyond a cell before it came to rest is none in
/// equilibrium: it could not stand as drawn. A `stop` that comes with the very step that meets the limit is too late:
/// the search has ended.
/// told: called after every step.
Search seek_equilibrium(const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop,
    const std::function<void()>& told = {});

}  // namespace terp
