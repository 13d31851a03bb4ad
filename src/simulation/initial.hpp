// The stress with which a run starts (reading R14). Not for: the search for equilibrium (equilibrium.hpp).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace terp {

/// InitialStress::k0: effective sigma_yy = weight of soil, free water and permanent loads above, as all of these are at
/// t = 0, less p_w, effective sigma_xx = sigma_zz = k0 sigma_yy; undrained soil stores them less p_w. None: zero.
/// With water the search for equilibrium begins with the same stress, where all bodies have outlines.
void set_initial_stress(const Model& model, State& state);

}  // namespace terp
