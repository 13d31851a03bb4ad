// The footings in a step: where they are, the nodes inside them, and what they push with.
// Not for: one footing and its motion (footing.hpp), nor the reaction of the soil (run/measure/footings).
#pragma once

#include "mpm/features/footing.hpp"
#include "mpm/step/workspace.hpp"

#include <array>
#include <vector>

namespace terp {

struct FootingsModel {
  std::vector<Footing> all;
};

/// Of each footing on its nodes [N s per m].
using FootingImpulses = std::array<Vec<2>, most_footings>;

struct FootingsScratch {
  std::vector<PlacedFooting> placed;            ///< in this step; none while the soil settles before t = 0
  std::vector<FootingImpulses> chunk_impulses;  ///< by chunk of nodes
  FootingImpulses impulses{};                   ///< in the last step
};

/// Of the model; empty: none.
std::span<const Footing> footings_of(const StepModel& model);

/// Puts the footings where they are in the coming step.
void place_footings(const StepModel& model, const StepState& state, Workspace& work);

/// Adds up what the chunks have, in their order.
void add_up_impulses(FootingsScratch& footings);

/// Number of the footing that holds a place, the last if several do; -1: none.
inline int footing_at(const Workspace& work, Vec<2> x)
{
  const FootingsScratch* footings = work.with.footings.get();
  if (footings == nullptr) return -1;
  for (int k = static_cast<int>(footings->placed.size()) - 1; k >= 0; --k)
    if (footings->placed[k].holds(x)) return k;
  return -1;
}

/// The footing has the last word on the nodes inside it. impulse: what that takes is added [N s per m].
inline void push_by_footing(const PlacedFooting& footing, Real mass, Vec<2>& v, Vec<2>& impulse)
{
  const Vec<2> before = v;
  footing.hold(v);
  for (int d = 0; d < 2; ++d) impulse[d] += mass * (v[d] - before[d]);
}

}  // namespace terp
