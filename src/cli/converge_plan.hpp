// Which runs a study of cell sizes consists of, which of them are there already, and what the others would cost.
#pragma once

#include "cli/commands.hpp"
#include "io/results/mesh_study.hpp"

#include <string>
#include <vector>

namespace terp {

/// How a run of the study comes about.
enum class RunStart { anew, again, goes_on, kept };

struct PlannedRun {
  std::size_t sequence = 0;          ///< in Plan::sequences
  std::size_t number = 0;            ///< in StudySequence::runs
  std::string label;                 ///< "cells of 0.5 m, scheme=mpm_mixed"
  std::string folder;                ///< path
  std::vector<std::string> changes;  ///< all of them, KEY=VALUE
  RunStart start = RunStart::anew;
  double seconds = 0.0;   ///< expected, of what is still to be solved
  std::string what = {};  ///< cells, points and steps, in words
};

struct Plan {
  std::string case_name, title, folder;
  std::vector<StudySequence> sequences;
  std::vector<PlannedRun> runs = {};         ///< all sizes of a sequence, then the next
  std::vector<std::string> not_varied = {};  ///< inputs that may decide and cannot be changed, with the reason
};

/// Reads the case at every size, shows each warning once, makes trial steps. Throws CaseError where a size or a variant
/// does not work, FileError where a folder holds another run and `force` is not set.
Plan plan_study(const ConvergeOptions& options);

/// The plan as the user sees it before it begins.
std::string plan_text(const Plan& plan, int threads);

}  // namespace terp
