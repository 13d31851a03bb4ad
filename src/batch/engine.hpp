// All realisations of a study, each on one thread, until the rule stops them.
#pragma once

#include "batch/estimates.hpp"
#include "batch/store.hpp"

#include <chrono>
#include <functional>

namespace terp {

struct EngineOptions {
  int threads = 1;
  StudyPart part = {};
  double look_every = 60.0;  ///< [s] of a part with a rule: the time between looks at what the others have solved
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();  ///< from which `stop.time` counts
  /// Called after each realisation, by one thread at a time. all: with what was there before.
  std::function<void(const Realisation& newest, const Realisations& all)> show = {};
};

enum class StudyEnd { rule_met, out_of_time, stopped };

/// Makes those of the numbers that are missing, drawn as the caller says, and appends them to the store.
StudyEnd solve_realisations(const Study& study, const std::string& folder, const EngineOptions& options,
    const std::atomic<bool>& stop, const std::vector<Index>& numbers, const std::function<Draw(Index)>& draw,
    Realisations& rows);

/// Makes what is missing of a part in the folder, which must be there, and appends it to the store. rows: what is there
/// already; filled. Throws FileError, and std::bad_alloc where the workers need more memory than there is.
StudyEnd run_realisations(const Study& study, const std::string& folder, const EngineOptions& options,
    const std::atomic<bool>& stop, Realisations& rows);

}  // namespace terp
