// What is said when the search for equilibrium does not end, or ends in another body than the one drawn: where, and
// what to do. Not for: the search itself (initial.hpp).
#pragma once

#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

/// Soil that yielded in the search and moved beyond its cell: another body came to rest than the one that was drawn.
struct Flow {
  Index n = 0;     ///< points
  Real way = 0.0;  ///< the longest [m]
};

Flow find_flow(const Model& model, const State& state);
std::string describe_flow(const Model& model, const State& state, const Flow& flow);

/// After all steps the forces are out of balance; `work` is that of the last one.
std::string describe_no_equilibrium(const Model& model, const State& state, const Workspace& work);

}  // namespace terp
