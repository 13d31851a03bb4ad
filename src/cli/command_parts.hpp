// Parts that the commands on the command line share.
#pragma once

#include "cli/commands.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>

namespace terp {

inline constexpr const char* exit_statuses =
    "Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else";

std::shared_ptr<CLI::Formatter> help_page();

/// A number from `least` to `most`, of which "nan" is none, or a whole number. The message says what is no number at
/// all.
CLI::Validator in_range(double least, double most);
CLI::Validator in_range(int least, int most);

/// words: the option, and how its value is called in the help: "-o,--output DIR". Without a dash: a place on the line.
template <class T>
CLI::Option* add_option(CLI::App* command, const std::string& words, T& value, const std::string& what)
{
  const std::size_t gap = std::min(words.find(' '), words.size());
  return command->add_option(words.substr(0, gap), value, what)
      ->option_text(gap < words.size() ? words.substr(gap + 1) : " ");
}

template <class T, class Number>
CLI::Option* add_number(
    CLI::App* command, const std::string& words, T& value, Number least, Number most, const std::string& what)
{
  return add_option(command, words, value, what)->check(in_range(least, most));
}

CLI::App* add_command(
    CLI::App& app, const char* name, const char* group, const std::string& what, const std::string& example);
void add_case(CLI::App* command, RunOptions& options, bool required = true);
void add_threads(CLI::App* command, int& threads);
void add_quiet(CLI::App* command, RunOptions& options, const char* what = "no progress, no summary; warnings stay");
void add_set(CLI::App* command, std::vector<std::string>& changes);
void add_language(CLI::App* command, std::string& language);
void add_output(CLI::App* command, std::string& output, const char* what, const char* text = "DIR");

/// Commands that begin with files of D-Stability (command_line_sections.cpp).
void declare_import(CLI::App& app, ImportCommand& command);
void declare_assess(CLI::App& app, AssessCommand& command);

}  // namespace terp
