// CLI11 writes the help; HelpPage changes only the parts of it that we want otherwise. Ranges have a validator of our
// own. That of CLI11 lets NaN pass, and has one message for a word and for a number out of range. Options that many
// commands have are declared here, so that they read alike in all of them.

#include "cli/command_parts.hpp"

#include "page/payload.hpp"

#include <fmt/format.h>

#include <cctype>
#include <vector>

namespace terp {
namespace {

/// CLI11's page with our layout: commands in one line each, no remark on how many of them are required.
class HelpPage : public CLI::Formatter {
 public:
  HelpPage()
  {
    column_width(25);
    label("OPTIONS", "options");
    label("SUBCOMMAND", "COMMAND");
    label("Positionals", "Arguments");
  }
  std::string make_description(const CLI::App* app) const override
  {
    std::string text = app->get_description();
    if (app->get_parent() != nullptr) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text + "\n\n";
  }
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override
  {
    const std::string name = CLI::Formatter::make_option_name(option, is_positional);
    const std::size_t comma = name.find(',');  // "-o,--output"
    return comma == std::string::npos ? name : name.substr(0, comma) + ", " + name.substr(comma + 1);
  }
  /// Without the other options that it cannot stand beside: the text of an option says that.
  std::string make_option_opts(const CLI::Option* option) const override
  {
    const std::string text = CLI::Formatter::make_option_opts(option);
    return text.substr(0, text.find(" Excludes:"));
  }
  std::string make_subcommand(const CLI::App* command) const override
  {
    const std::string text = command->get_description();
    return fmt::format("  {:<23}{}\n", command->get_name() + arguments_of(*command), text.substr(0, text.find('\n')));
  }

 private:
  static std::string arguments_of(const CLI::App& command)
  {
    std::string names;
    for (const CLI::Option* option : command.get_options([](const CLI::Option* o) { return o->get_positional(); }))
      names +=
          (option->get_required() ? " " : " [") + option->get_name(true, false) + (option->get_required() ? "" : "]");
    return names;
  }
};

/// Number: that of the option. What is no number at all is told apart from what is out of range.
template <class Number>
CLI::Validator checked_between(Number least, Number most, const char* kind)
{
  return CLI::Validator(
      [least, most, kind](std::string& text) -> std::string {
        Number value{};
        if (!CLI::detail::lexical_cast(text, value))
          return fmt::format("`{}` is no {}; allowed are {:g} to {:g}", text, kind, double(least), double(most));
        if (value >= least && value <= most) return "";
        return fmt::format("{} is out of range; allowed are {:g} to {:g}", text, double(least), double(most));
      },
      CLI::Range(least, most).get_description());
}

}  // namespace

std::shared_ptr<CLI::Formatter> help_page() { return std::make_shared<HelpPage>(); }

CLI::Validator in_range(double least, double most) { return checked_between(least, most, "number"); }

CLI::Validator in_range(int least, int most) { return checked_between(least, most, "whole number"); }

CLI::App* add_command(
    CLI::App& app, const char* name, const char* group, const std::string& what, const std::string& example)
{
  CLI::App* command = app.add_subcommand(name, what);
  command->group(group);
  command->formatter(help_page());
  command->set_help_flag();
  command->footer((example.empty() ? "" : "Examples:\n" + example + "\n") + exit_statuses);
  return command;
}

void add_case(CLI::App* command, RunOptions& options, bool required)
{
  add_option(command, "CASE.toml", options.path, "the case file (terp explain, docs/conventions.md)")
      ->required(required);
}

void add_threads(CLI::App* command, int& threads)
{
  add_number(command, "-j,--threads N", threads, 1, 1024,
      "CPU threads (default: what this job may use);\nresults have the same bits on any number");
}

void add_quiet(CLI::App* command, RunOptions& options, const char* what)
{
  command->add_flag("-q,--quiet", options.quiet, what);
}

void add_set(CLI::App* command, std::vector<std::string>& changes)
{
  add_option(command, "--set KEY=VALUE", changes,
      "change one key of the case; may be given several\ntimes. * stands for any name: material.*.eta=40")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_language(CLI::App* command, std::string& language)
{
  add_option(command, "--language L", language, "of the page: en, nl (default en); it can be\nchanged on the page")
      ->check(CLI::IsMember(std::vector<std::string>(report_languages.begin(), report_languages.end())));
}

void add_output(CLI::App* command, std::string& output, const char* what, const char* text)
{
  add_option(command, fmt::format("-o,--output {}", text), output, what);
}

}  // namespace terp
