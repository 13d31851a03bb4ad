// From the words of a command line to the status of the program.
// Not for: what may stand there (command_line.hpp).
#pragma once

#include "cli/command_line.hpp"

#include <functional>

namespace terp {

/// Does what was parsed; returns the exit status.
using Command = std::function<int(const CLI::App& app, const CommandLine& line)>;

/// The function of each command.
int call_command(const CLI::App& app, const CommandLine& line);

/// Answers help and version by itself.
int answer(int argc, char** argv, const Command& call);

/// That of the call; what it throws is told on standard error.
int status_of(const std::function<int()>& call);

}  // namespace terp
