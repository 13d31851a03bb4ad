// terp study run: solving, on threads of this process or on processes that a launcher started together.
#pragma once

#include "cli/commands.hpp"
#include "batch/study.hpp"
#include "os/children.hpp"
#include "os/launcher.hpp"

#include <optional>
#include <string>

namespace terp {

/// Solves what is missing of a study in a folder. Returns the status of the program.
int run_study(const Study& study, const std::string& folder, const StudyCommand& command, const Launched& launched);

/// Under a launcher, before the study is opened: begins the worker of this rank in a process of its own, so that a
/// worker that dies does not end the rank, and with it the job. Returns the status of a worker, and of a rank above 0
/// when its worker has ended; none: this is rank 0, which goes on.
std::optional<int> begin_worker(const StudyCommand& command, const Launched& launched, Children& worker);

}  // namespace terp
