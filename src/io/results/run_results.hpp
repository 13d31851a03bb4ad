// All that a run folder holds, finished or still growing: what the report, comparisons and exports read.
// Not for: going on with a run (io/files/checkpoint).
#pragma once

#include "io/files/summary_json.hpp"
#include "io/results/frames.hpp"
#include "io/results/table.hpp"

#include <optional>

namespace terp {

/// Read when made: summary and tables. Frames are read when asked for.
struct RunResults {
  std::string folder;
  std::string name;       ///< of the folder: "model_2_gp"
  std::string case_toml;  ///< text of case.toml
  SavedSummary summary;
  Table ledger = {};
  std::vector<PointTable> history = {};

  Frames frames() const { return Frames(folder); }
};

/// Throws FileError that says what is missing and what to do.
RunResults read_run(const std::string& folder);

/// True while the run goes on, or if it was killed: summary.json is written when it ends or is stopped.
bool summary_is_behind(const RunResults& run);

/// Names of runs side by side: the folders' names, as much of their paths as tells them apart.
std::vector<std::string> distinct_names(const std::vector<std::string>& folders);

}  // namespace terp
