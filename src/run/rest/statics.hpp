// The soil of a state as a problem of statics: forces out of balance of the nodes, and the soil strained by their
// displacements, with the points where they are. Not for: which displacements (static_search.hpp).
#pragma once

#include "model/parts/model.hpp"
#include "mpm/features/search.hpp"
#include "mpm/features/sides.hpp"
#include "mpm/step/kept_soil.hpp"
#include "mpm/step/workspace.hpp"
#include "run/loop/state.hpp"

#include <span>

namespace terp {

/// Numbers of the nodes that move, two for each: x and y.
using NodeVector = std::vector<Real>;

class Statics {
 public:
  /// The workspace settles meanwhile. Both must outlive this.
  Statics(const Model& model, State& state, Workspace& work);
  ~Statics() { work_.with.search.clear(); }
  Statics(const Statics&) = delete;
  Statics& operator=(const Statics&) = delete;

  /// Of the soil as it is: forces that no side carries [N per m], what was held back of them with this share. Where one
  /// is no number (is_finite) they stay those of before, and the ratios are infinite.
  void find_forces(Real held_share);
  /// What find_forces holds back from then on: the forces that it found last.
  void hold_forces();
  /// Displacements of all nodes [m].
  void strain(std::span<const Real> u);

  /// The soil of the forces found last, from which strain() begins after go_back().
  void keep() { kept_.keep(model_, state_, work_); }
  void go_back() { kept_.put_back(state_, work_); }
  /// To the soil of the constructor.
  void go_back_to_start() { start_.put_back(state_, work_); }

  const NodeVector& forces() const { return forces_; }
  Real ratio() const { return ratio_; }            ///< sum of the sizes of the forces over that of the weights [-]
  Real ratio_of_most() const { return of_most_; }  ///< force over own weight that 99 % of the mass does not exceed
  bool is_finite() const { return work_.finite; }

  const Model& model() const { return model_; }
  const State& state() const { return state_; }
  const Workspace& work() const { return work_; }

 private:
  const Model& model_;
  State& state_;
  Workspace& work_;
  NodeVector forces_, all_, held_;
  Real ratio_ = 0.0, of_most_ = 0.0;
  KeptSoil start_, kept_;
};

}  // namespace terp
