// The part of a run that a model is of: a stage, or the whole of a run that has none.
// Not for: how one follows another (stages.hpp).
#pragma once

#include "math/types.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace terp {

/// From one value to another over time.
struct Ramp {
  Real start = 0.0, duration = 0.0;  ///< [s]

  /// Share of the new value at a time: 0 before the ramp, 1 after it.
  Real share_at(Real time) const
  {
    return duration > 0.0 ? std::clamp((time - start) / duration, Real(0.0), Real(1.0)) : 1.0;
  }
};

/// When soil is at rest: all nodes that hold soil have been slow for a time, or hardly any soil went far in that time;
/// and nothing is about to change.
struct RestRule {
  Real speed = 0.0;           ///< [m/s]
  std::int64_t steps = 0;     ///< in which all nodes are slower than that; 0: rest ends nothing
  bool by_mean = false;       ///< it is the mean motion in these steps that counts
  bool with_verdict = false;  ///< the steps are at least those in which the soil swings once (RestMarks::swing),
                              ///< by_mean; and the answer of a follower ends the stage, too
  Real distance = 0.0;        ///< which soil may go in these steps, by_mean [m]
  Real volume = 0.0;          ///< of soil that may go farther: a cell [m^2]
  Real last_change = 0.0;     ///< time of the last change of loads or water that the case orders [s]; infinite: no end
};

/// Where points were when soil was looked at for its mean motion, four times in the time of RestRule: as often it is
/// looked at whether they went far.
struct RestMarks {
  static constexpr std::int64_t n = 4;
  std::int64_t steps = 0;    ///< since the first of them
  std::int64_t swing = 0;    ///< of a stage that ends with the verdict: its RestRule::steps; 0: not yet known
  bool rests = false;        ///< in that stage: hardly any ground went far, at the last look
  std::vector<Real> places;  ///< shape [n, n_ids, 2] [m]; empty: none so far
};

/// The water of a stage: on the way from one situation to another, by their numbers.
struct StageWater {
  bool given = false;  ///< no stage has said so far: the water follows its own times
  std::size_t from = 0, to = 0;
};

struct Stage {
  std::string name;                   ///< empty: the run has no stages
  std::size_t number = 0, n_all = 1;  ///< of all stages
  std::int64_t steps = 0;             ///< at most
  std::int64_t steps_after = 0;       ///< of the stages after it, at most
  RestRule rest;
  StageWater water;

  bool is_last() const { return number + 1 == n_all; }
};

struct StageRecord {
  Real start = 0.0, end = 0.0;  ///< [s]
  std::int64_t steps = 0;
  bool at_rest = false;  ///< ended so
  Real fastest = 0.0;    ///< speed of the fastest node in its last step [m/s]; NaN: not looked at, or without weight
  Real known_for = 0.0;  ///< the verdict ended it, known for this long [s]; 0: it did not
};

}  // namespace terp
