// What may stand on the command line: commands, options, and the help that CLI11 prints of them.
// Not for: what the commands do (commands.hpp).
#pragma once

#include "cli/commands.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace terp {

struct CommandLine {
  RunOptions options;
  StabilityOptions stability;
  std::vector<double> stability_cells;  ///< of stability: sizes [m]
  ConvergeOptions converge;
  StudyCommand study;
  std::string topic;
  ReportCommand report;
  ExportCommand exported;
  WatchCommand watch;
  SeepageCommand seepage;
  ElementCommand element;
  ImportCommand imported;
  AssessCommand assess;
};

/// Declares all commands; what is parsed goes to `line`, which must outlive the app.
void declare(CLI::App& app, CommandLine& line);

/// The page of a command; of the whole program if there is no such command.
std::string help_on(const CLI::App& app, const std::string& command);

/// An error of CLI11 in our words: the nearest option, what is missing, where help is.
std::string describe(const CLI::App& app, const CLI::ParseError& error);

}  // namespace terp
