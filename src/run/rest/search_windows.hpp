// What the search for equilibrium looks at from window to window: how far its soil moved, and whether it rests or runs
// away. A window is the time in which a shear wave goes down the soil and up again.
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <optional>

namespace terp {

/// Of its weight; more may be out of balance in a hundredth of soil that rests.
inline constexpr Real part_out_of_balance = 1e-3;

class SearchWindows {
 public:
  /// stiffening: of the model; what is said of displacements is said of the soil as it is.
  SearchWindows(const Model& model, const State& state, Real stiffening);

  std::int64_t steps() const { return steps_; }  ///< of a window

  /// At the end of a window. counts: the forces are all there, so that the window is judged.
  void enter(const State& state, Real out_of_balance, bool counts);

  /// In the last window no hundredth of the soil moved as if more than a thousandth of its weight were out of balance.
  bool at_rest() const;
  /// A hundredth of the soil moved further than what counts as moved (docs/formats.md), more in each of the last two
  /// windows than in the one before, and no force became smaller meanwhile. Soil that comes to rest may move faster for
  /// some windows; the force out of balance then falls.
  bool runs_away() const;
  /// What 99 % of the points moved less than, by the end of the last window [m].
  Real moved() const { return moved_.empty() ? 0.0 : moved_.back(); }
  /// Steps to the limit and to rest if force and motion go on falling as in the last window; none: they do not,
  /// the soil swings, or nothing is known.
  std::optional<std::int64_t> more_steps(Real out_of_balance, Real limit) const;

 private:
  Real moved_in(std::size_t back) const;

  Real stiffening_;
  std::int64_t steps_ = 1;
  Real still_ = 0.0;                  // motion in a window of soil at rest [m]
  Real failed_ = 0.0;                 // displacement that counts as moved [m]
  std::vector<Real> moved_;           // by the ends of the windows that count [m]
  std::vector<Real> out_of_balance_;  // at the same times [-]
};

}  // namespace terp
