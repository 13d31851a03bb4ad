// terp study run: solving on threads of this process, where others may solve other parts of the study.
#pragma once

#include "cli/commands.hpp"
#include "batch/study.hpp"
#include "os/launcher.hpp"

#include <string>

namespace terp {

/// Solves what is missing of a study in a folder, or of a part: that of --part, or else the one of this process among
/// those that were launched. Returns the status of the program.
int run_study(const Study& study, const std::string& folder, const StudyCommand& command, const Launched& launched);

}  // namespace terp
