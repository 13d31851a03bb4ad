// The search for equilibrium without motion: displacements of the nodes that leave no force out of balance, found with
// the elastic stiffness (decision 0082). Not for: soil that fails, which only motion shows (settle, equilibrium.hpp).
#pragma once

#include "run/rest/equilibrium.hpp"

namespace terp {

enum class StaticEnd {
  rests,    ///< the state is that of the soil at rest
  unknown,  ///< the forces do not fall any more, or did not fall far enough; the state is that of the start
  stopped,
};

/// The forces come on in ten parts. After each the soil is strained by the whole of its displacements from the end of
/// the part before, so that the iterations leave no trace in its stress. It rests when the force out of balance is
/// below initial.limit and 99 % of its mass have less than a thousandth of their own weight out of balance.
/// n_iterations: in and out, added to. report: after each.
StaticEnd search_statically(const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop,
    const SearchCallback& report, std::int64_t& n_iterations);

}  // namespace terp
