// [time] and [[stage]] as the case file has them.
#pragma once

#include "math/types.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace terp {

struct Case;

/// Verdict: when it is known whether the ground holds the water, and what of it remains.
enum class Until { end, at_rest, verdict };

/// Which soil must be slow where something ends at rest: the fastest node, or soil in its mean motion over `rest_time`.
enum class RestBy { fastest, mean };

struct TimeCase {
  Real end = 0.0;            ///< [s]; of a run that may end before, or with stages: the latest time that it may come to
  Until until = Until::end;  ///< of a run without stages
  Real at_most = 0.0;        ///< of a run that may end before: the same as `end` [s]
  RestBy rest_by = RestBy::fastest;
  Real rest_speed = 1e-3;  ///< speed below which all nodes, or points in their mean, must stay [m/s]
  Real rest_time = 0.5;    ///< for this long [s]
  Real courant = 0.98;     ///< dt = courant * min(L_e) / c_p, reading R19
};

/// A part of a run with values of its own for some keys.
struct StageCase {
  std::string name;
  Real duration = 0.0;  ///< [s]
  Until until = Until::end;
  Real at_most = 0.0;                      ///< of one that may end before [s]
  Real ramp = 0.0;                         ///< over which gravity, loads, water, at_strength change [s]
  std::string water;                       ///< situation that the water goes to; empty: it stays
  std::vector<std::string> place, remove;  ///< names of bodies
  bool reset_displacement = false;         ///< displacement and strain are zero at its start
  bool trigger = false;                    ///< it makes the section fail: FloodTrigger
  std::vector<std::pair<std::string, std::string>> changes;  ///< keys and their values as TOML, as written
  std::shared_ptr<const Case> changed = nullptr;  ///< the case with the changes of this stage and all before it

  /// [s]
  Real longest() const { return until == Until::end ? duration : at_most; }
};

}  // namespace terp
