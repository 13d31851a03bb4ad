// One trial: does the soil stand with strengths reduced by a factor? Criterion and reasons: docs/stability.md.
#pragma once

#include "run/stability/elastic_start.hpp"
#include "run/stability/mechanism.hpp"
#include "run/stability/soil_motion.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace terp {

/// Undecided: neither came to rest nor ran away in the time that it had.
enum class TrialVerdict { stable, failed, undecided };

/// When a trial ends, in scales that are free of the case's units.
struct TrialRules {
  Real damping = 0.5;        ///< local damping [-]
  Real rest = 2e-5;          ///< stable: moves less in a window than it would under this share of its weight
                             ///< (ElasticStart::free_motion)
  Real failure = 4.0;        ///< failed: displacement beyond this many rho g H^2 / E, and it does not slow down
  Index most_windows = 200;  ///< undecided after so many windows
  Real least_depth = 0.0;    ///< of soil whose motion counts below the ground [m]
  Real stiffening =
      1000.0;  ///< displacements are kept this many times smaller than they were (stiffen()); 1: as they are
};

/// What is looked at after each window: the time in which a shear wave goes down the soil and up again. Of the soil as
/// it is: what the stiffer soil of the trial does, turned back.
struct TrialWindow {
  Real time = 0.0;          ///< at its end [s]
  Real displacement = 0.0;  ///< mean of the one per cent of the judged points that moved furthest [m]
  Real out_of_balance =
      0.0;  ///< sum |m a| over sum |m g| of the judged nodes, m a the mean over the window [-]; reported, not judged
};

struct Trial {
  Real factor = 0.0;
  TrialVerdict verdict = TrialVerdict::undecided;
  std::string reason;  ///< in words
  std::int64_t steps = 0;
  int threads = 1;  ///< that the system granted
  double wall_s = 0.0;
  std::vector<TrialWindow> windows;
  std::shared_ptr<const Mechanism> mechanism = {};  ///< of one that did not stand and had two windows; else null
};

/// Judges the windows so far by the scales of `start`; undecided: go on, or, after the last, undecided.
TrialVerdict judge(const std::vector<TrialWindow>& windows, const TrialRules& rules, const ElasticStart& start);

/// The trials of a case: mesh and elastic rest are made once, so that every factor starts from the same state.
struct Trials {
  Trials(const Case& c, const TrialRules& of_all, int n_threads, const std::atomic<bool>& may_stop);

  /// report: called after each window. Ends undecided where it is when `stop` is set.
  Trial run(
      Real factor, const std::function<void(const Trial&)>& report = [](const Trial&) {}) const;

  Case quiet;
  SharedMesh mesh;
  ElasticStart start;
  TrialRules rules;
  Judged judged;
  int threads;
  const std::atomic<bool>& stop;
};

}  // namespace terp
