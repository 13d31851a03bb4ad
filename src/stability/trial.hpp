// One trial: does the soil stand with strengths reduced by a factor? Criterion and reasons: docs/stability.md.
#pragma once

#include "stability/elastic_start.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace terp {

/// Undecided: neither came to rest nor ran away in the time that it had.
enum class TrialVerdict { stable, failed, undecided };

/// When a trial ends, in scales that are free of the case's units.
struct TrialRules {
  Real damping = 0.5;          ///< local damping [-]
  Real rest = 1e-4;            ///< stable: out-of-balance force over weight, mean of a window
  Real failure = 1.0;          ///< failed: displacement beyond this many rho g H^2 / E, and it does not slow down
  Index most_windows = 40;     ///< undecided after so many windows
};

/// What is looked at after each window: the time in which a shear wave goes down the soil and up again.
struct TrialWindow {
  Real time = 0.0;             ///< at its end [s]
  Real displacement = 0.0;     ///< mean of the one per cent of the points that moved furthest [m]
  Real out_of_balance = 0.0;   ///< sum |m a| over sum |m g|, mean over the window [-]
};

struct Trial {
  Real factor = 0.0;
  TrialVerdict verdict = TrialVerdict::undecided;
  std::string reason;          ///< in words
  std::int64_t steps = 0;
  double wall_s = 0.0;
  std::vector<TrialWindow> windows;
};

/// Judges the windows so far; undecided: go on, or, after the last, undecided. displacement: ElasticStart::displacement [m].
TrialVerdict judge(const std::vector<TrialWindow>& windows, const TrialRules& rules, Real displacement);

/// Runs a trial. told: called after each window. Throws RunError if `stop` was set.
Trial run_trial(const Case& quiet, const Mesh<2>& mesh, const ElasticStart& start, Real factor, const TrialRules& rules, int threads,
                const std::atomic<bool>& stop, const std::function<void(const Trial&)>& told);

}  // namespace terp
