// The commands of the program, one function each. Each returns the exit status.
#pragma once

#include "stability/trial.hpp"

#include <optional>
#include <string>
#include <vector>

namespace terp {

/// Exit statuses, as the help promises.
enum Status { solved = 0, failed = 1, bad_input = 2, stopped_itself = 3 };

struct RunOptions {
  std::string path;                  ///< case file, or run folder or checkpoint for resume
  std::string output;                ///< run folder; empty: runs/<case>
  std::vector<std::string> changes;  ///< KEY=VALUE of --set
  int threads = 0;                   ///< 0: what this job may use
  bool force = false, quiet = false, verbose = false;
  long steps = 100, warm_steps = 50; ///< of bench: in each of five trials, and before them
  bool json = false;                 ///< of bench
};

/// Of terp stability; meanings and defaults in docs/stability.md.
struct StabilityOptions {
  RunOptions run;
  std::optional<Real> from, to;   ///< factors to try first
  Real tolerance = 0.02, damping = TrialRules{}.damping, rest = TrialRules{}.rest, failure = TrialRules{}.failure;
  Index windows = TrialRules{}.most_windows;
};

int run_case(const RunOptions& options);
int find_stability(const StabilityOptions& options);
int resume_run(const RunOptions& options);
int check_case(const RunOptions& options);
int bench_case(const RunOptions& options);

}  // namespace terp
