// How the soil moves in a trial: the way of its fastest part, and the forces that are out of balance.
// Not for: the verdict (trial).
#pragma once

#include "math/types.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

namespace terp {

struct Workspace;

/// Whether a point counts, by id; empty: all do.
using Judged = std::vector<char>;

/// Points that at rest lie at least so deep below the ground [m]. Throws InputError if there is none.
Judged points_below(const Model& model, const State& state, Real depth);

/// Mean displacement of the one per cent of the judged points that moved furthest [m].
Real displacement_of_the_fastest(const State& state, const Judged& judged);

/// Forces at the nodes as a mean over steps: vibration cancels, motion does not.
class OutOfBalance {
 public:
  explicit OutOfBalance(const Model& model) : force_(model.mesh->nodes.size(), Vec<2>{0.0, 0.0}) {}

  /// Those of the last step.
  void add_forces(const Model& model, const Workspace& work);
  /// sum |mean m a| over sum |m g| of the nodes, the mean over the steps since this was last called [-].
  Real take_share();

 private:
  std::vector<Vec<2>> force_;  // sum of m a over the steps, by node [N per m]
  Real weight_ = 0.0;          // sum of |m g| over nodes and steps [N per m]
};

}  // namespace terp
