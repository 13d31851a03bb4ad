// The search for equilibrium in a step: forces that are held, and damping that follows the slowest motion. Its slot is
// full while the soil settles; then there are neither footings nor loads for a time.
// Not for: how the search goes on (run/rest/equilibrium).
#pragma once

#include "mpm/step/workspace.hpp"

#include <vector>

namespace terp {

struct SearchScratch {
  std::vector<Vec<2>> held;             ///< what held each node at rest in the first step [N per m], shape [n_nodes]
  std::vector<Vec<2>> last;             ///< out of balance at the last step [N per m], shape [n_nodes]
  Real share = 0.0;                     ///< of the held forces that has been let go; 0: of the first step
  Real damping_local = 0.0;             ///< alpha in force, instead of the model's
  Real viscous = 0.0;                   ///< damping in proportion to the nodal mass [1/s]
  Real stiffness = 0.0, inertia = 0.0;  ///< v K v and v M v in the last step [N m/s^2 per m]
};

/// From the next step on the soil settles, its first forces out of balance held.
SearchScratch& begin_search(Real damping_local, Workspace& work);

/// The first forces out of balance come on by and by: what has not come is held.
inline void hold_back(SearchScratch& search, Index i, Vec<2>& out_of_balance)
{
  if (search.share == 0.0) search.held[i] = {-out_of_balance[0], -out_of_balance[1]};
  for (int d = 0; d < 2; ++d) out_of_balance[d] += (1.0 - search.share) * search.held[i][d];
}

/// What damping that follows the slowest motion needs: v . dR/dt and v . M v.
inline void follow_motion(SearchScratch& search, Index i, Vec<2> force, Vec<2> v, Real momentum_per_v, NodeSums& sums)
{
  for (int d = 0; d < 2; ++d) {
    sums.stiffness += v[d] * (search.last[i][d] - force[d]);
    sums.inertia += momentum_per_v * v[d] * v[d];
    search.last[i][d] = force[d];
  }
}

}  // namespace terp
