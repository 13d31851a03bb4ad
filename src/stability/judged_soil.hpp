// The soil that a trial looks at, and how it moves: that of filled cells (decision 0036).
// Not for: the verdict (trial).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

/// Chosen once, where the soil is at rest. Where none of it is left, all soil is judged.
class JudgedSoil {
 public:
  JudgedSoil(const Model& model, const State& state);

  /// Mean displacement of the one per cent of its points that moved furthest [m].
  Real largest_displacement(const State& state) const;
  /// Adds the forces of the last step at its nodes.
  void add_forces(const Model& model, const Workspace& work);
  /// sum |mean m a| over sum |m g| of its nodes, the mean over the steps since this was last called [-]: vibration
  /// cancels, motion does not.
  Real take_out_of_balance();

 private:
  std::vector<bool> point_;    // by id: no node of its cell is out of the count
  std::vector<bool> node_;     // no part-filled cell holds it
  std::vector<Vec<2>> force_;  // sum of m a over the steps, by node [N per m]
  Real weight_ = 0.0;          // sum of |m g| over nodes and steps [N per m]
};

}  // namespace terp
