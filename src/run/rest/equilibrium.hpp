// The search for equilibrium: the stress with which soil rests in the section as it is drawn (decision 0050).
// Not for: the stress that it begins with (initial.hpp), nor what is said when there is none (no_equilibrium.hpp).
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <atomic>
#include <functional>
#include <optional>
#include <string>

namespace terp {

struct Workspace;

/// How the search ended; neither: it was stopped, and begins anew later.
struct Search {
  bool reached = false;
  std::string fault = {};        ///< what went wrong
  bool slides_as_drawn = false;  ///< soil runs away with the strength that it has
};

struct SearchProgress {
  std::int64_t steps = 0;
  Real out_of_balance = 0.0;                 ///< force over weight [-]
  std::optional<std::int64_t> more_steps{};  ///< that it will take at the rate of the last window; none: not yet known
};

using SearchCallback = std::function<void(const SearchProgress&)>;

/// Brings the soil of the model to rest with the clock at 0: without motion where that finds the state at rest
/// (static_search.hpp), else in motion. Then displacement, velocity, strain and history are set to zero. stiffening: of
/// the model (stiffen()), by which displacements are reported as those of the soil as it is. report: after every step.
Search settle(const Model& model, State& state, Workspace& work, Real stiffening, const std::atomic<bool>& stop,
    const SearchCallback& report = {});

/// The same in motion alone. The first forces out of balance come on over some windows of time, and damping follows the
/// slowest motion. The soil rests when the out-of-balance force is below `initial.limit` and no part of it moves on.
/// State::equilibrium_steps is added to.
Search settle_in_motion(const Model& model, State& state, Workspace& work, Real stiffening,
    const std::atomic<bool>& stop, const SearchCallback& report = {});

/// The stress of InitialStress::equilibrium. The soil settles at displacements so small that it keeps its shape,
/// without softening; where strengths are divided (Case::at_strength), without any limit to them. The state takes the
/// stress alone, so that it begins in the section as drawn. Where there is no equilibrium the state is that of the
/// search, to look at, with the displacements of the soil as it is.
Search find_equilibrium(
    const Model& model, State& state, const std::atomic<bool>& stop, const SearchCallback& report = {});

}  // namespace terp
