// Parts that the commands on the command line share.
#pragma once

#include "commands.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace terp {

inline constexpr const char* exit_statuses =
    "Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else";

/// CLI11's page with our layout.
std::shared_ptr<CLI::Formatter> help_page();

/// A number from `least` to `most`, of which "nan" is none. The message says what is no number at all.
CLI::Validator number_between(double least, double most);
CLI::Validator whole_number_between(int least, int most);

CLI::App* add_command(CLI::App& app, const char* name, const char* group, const char* what, const std::string& example);
void add_case(CLI::App* command, RunOptions& options, bool required = true);
void add_threads(CLI::App* command, int& threads);
void add_quiet(CLI::App* command, RunOptions& options, const char* what = "no progress, no summary; warnings stay");
void add_set(CLI::App* command, RunOptions& options);
void add_language(CLI::App* command, std::string& language);
void add_output(CLI::App* command, std::string& output, const char* what, const char* text = "DIR");

/// Commands that begin with files of D-Stability (command_line_sections.cpp).
void declare_import(CLI::App& app, ImportCommand& command);
void declare_assess(CLI::App& app, AssessCommand& command);

}  // namespace terp
