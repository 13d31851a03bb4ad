// The program: reads the command line and calls one function per command.

#include "commands.hpp"
#include "help.hpp"
#include "input/case_file.hpp"
#include "input/closest.hpp"
#include "input/explain.hpp"
#include "input/printable.hpp"
#include "parallel/kernels.hpp"
#include "parallel/memory.hpp"
#include "stability/limits.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace {

/// Gives standard input, output and error a place if whoever started us closed them: a table would get their numbers
/// otherwise, and with it all that we print. POSIX hands out the lowest free number, so each one opened fills the gap.
bool keep_standard_streams()
{
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != descriptor) return false;
  return true;
}

struct CommandLine {
  terp::RunOptions options;
  terp::StabilityOptions stability;
  terp::VerifyOptions verify;
  std::string topic;
  terp::ReportCommand report;
  terp::ExportCommand exported;
  terp::WatchCommand watch;
};

/// A number from `least` to `most`. CLI::Range alone lets "nan" through, as no comparison with it holds.
CLI::Validator number_between(double least, double most)
{
  const CLI::Validator range = CLI::Range(least, most);
  return CLI::Validator(
      [range, least, most](std::string& text) {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && std::isnan(value))
          return fmt::format("Value {} not in range {:f} to {:f}", text, least, most);
        return range(text);
      },
      range.get_description());
}

CLI::App* add_case_command(CLI::App& app, const char* name, CommandLine& line)
{
  CLI::App* command = app.add_subcommand(name);
  command->add_option("case", line.options.path)->required();
  command->add_option("-j,--threads", line.options.threads)->check(CLI::Range(1, 1024));
  command->add_flag("-q,--quiet", line.options.quiet);
  command->add_flag("-v,--verbose", line.options.verbose);
  return command;
}

CLI::App* add_stability_command(CLI::App& app, CommandLine& line)
{
  CLI::App* command = add_case_command(app, "stability", line);
  const auto factors = number_between(terp::least_factor, terp::greatest_factor), shares = number_between(0.0, 0.99);
  command->add_option("--from", line.stability.search.from)->check(factors);
  command->add_option("--to", line.stability.search.to)->check(factors);
  command->add_option("--tolerance", line.stability.search.tolerance)
      ->check(number_between(terp::least_tolerance, terp::greatest_tolerance));
  command->add_option("--damping", line.stability.rules.damping)->check(shares);
  command->add_option("--rest", line.stability.rules.rest)->check(number_between(1e-9, 0.1));
  command->add_option("--failure", line.stability.rules.failure)->check(number_between(1e-3, 1e3));
  command->add_option("--windows", line.stability.rules.most_windows)->check(CLI::Range(3, 100000));
  command->add_option("--stiffening", line.stability.rules.stiffening)->check(number_between(1.0, 1e6));
  command->add_option("-o,--output", line.options.output);
  command->add_flag("--json", line.options.json);
  return command;
}

void declare_verify(CLI::App& app, terp::VerifyOptions& options)
{
  CLI::App* verify = app.add_subcommand("verify");
  verify->add_option("cases", options.names);
  verify->add_option("--cases", options.cases);
  verify->add_option("--html", options.html);
  verify->add_option("--markdown", options.markdown);
  verify->add_option("--overview", options.overview);
  verify->add_option("-j,--threads", options.threads)->check(CLI::Range(1, 1024));
  verify->add_flag("--list", options.list);
  CLI::Option* only_short = verify->add_flag("--short", options.only_short);
  verify->add_flag("--long", options.only_long)->excludes(only_short);
}

void declare(CLI::App& app, CommandLine& line)
{
  app.set_help_flag();
  app.set_help_all_flag();
  app.require_subcommand(1);
  CLI::App* run = add_case_command(app, "run", line);
  run->add_option("-o,--output", line.options.output);
  run->add_flag("--force", line.options.force);
  run->add_flag("--report", line.options.report);
  CLI::App* check = add_case_command(app, "check", line);
  add_case_command(app, "resume", line)->add_flag("--report", line.options.report);
  CLI::App* bench = app.add_subcommand("bench");
  bench->add_option("case", line.options.path);
  bench->add_option("-j,--threads", line.options.threads)->check(CLI::Range(1, 1024));
  bench->add_option("--steps", line.options.steps)->check(CLI::Range(1, 1000000));
  bench->add_option("--warm", line.options.warm_steps)->check(CLI::Range(0, 1000000));
  bench->add_flag("--json", line.options.json);
  CLI::App* stability = add_stability_command(app, line);
  declare_verify(app, line.verify);
  CLI::App* report = app.add_subcommand("report");
  report->add_option("runs", line.report.runs)->required();
  report->add_option("-o,--output", line.report.output);
  CLI::App* compare = app.add_subcommand("compare");
  compare->add_option("runs", line.report.runs)->required();
  compare->add_flag("--json", line.report.json);
  CLI::App* exported = app.add_subcommand("export");
  exported->add_option("run", line.exported.run)->required();
  exported->add_option("--format", line.exported.format);
  exported->add_option("--field", line.exported.fields)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  exported->add_option("--frames", line.exported.frames);
  exported->add_option("-o,--output", line.exported.folder);
  CLI::App* watch = app.add_subcommand("watch");
  watch->add_option("run", line.watch.run)->required();
  watch->add_option("--every", line.watch.every)->check(number_between(0.1, 3600.0));
  watch->add_flag("--once", line.watch.once);
  for (CLI::App* command : {run, check, bench, stability})
    command->add_option("--set", line.options.changes)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_subcommand("explain")->add_option("topic", line.topic)->required();
  app.add_subcommand("list");
}

/// The first word must be a command; throws CaseError with the nearest one if it is not.
void check_command(const CLI::App& app, const std::string& word)
{
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  std::string hint;
  if (const std::string nearest = terp::closest(word, names); !nearest.empty())
    hint = fmt::format("  Did you mean `{}`?\n", nearest);
  if (word.ends_with(".toml")) hint = fmt::format("  To solve that case: terp run {}\n", word);
  const std::string message =
      fmt::format("error: there is no command `{}`\n{}  Commands: {}\n", word, hint, fmt::join(names, ", "));
  throw terp::CaseError(terp::printable(message + "Usage: terp COMMAND [options]; see terp --help\n"));
}

int call(const CLI::App& app, const CommandLine& line)
{
  if (app.got_subcommand("run")) return terp::run_case(line.options);
  if (app.got_subcommand("resume")) return terp::resume_run(line.options);
  if (app.got_subcommand("stability")) return terp::find_stability(line.options, line.stability);
  if (app.got_subcommand("check")) return terp::check_case(line.options);
  if (app.got_subcommand("report")) return terp::report_runs(line.report);
  if (app.got_subcommand("compare")) return terp::compare_folders(line.report);
  if (app.got_subcommand("export")) return terp::export_run(line.exported);
  if (app.got_subcommand("watch")) return terp::watch_run(line.watch);
  if (app.got_subcommand("bench")) return terp::bench_case(line.options);
  if (app.got_subcommand("verify")) return terp::verify_cases(line.verify);
  fmt::print("{}", app.got_subcommand("explain") ? terp::explain(line.topic) : terp::list());
  return terp::solved;
}

/// Help and version are answered wherever they stand on the line; help on a command if it begins with one.
bool answer_help(int argc, char** argv)
{
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (k == 1 && word == "help") return fmt::print("{}", argc > 2 ? terp::help_on(argv[2]) : terp::help()), true;
    if (word == "-h" || word == "--help") return fmt::print("{}", terp::help_on(argv[1])), true;
    if (word == "--version") return fmt::print("terp {} ({})\n", TERP_VERSION, terp::kernels().instructions), true;
  }
  if (argc == 1) fmt::print("{}", terp::help());
  return argc == 1;
}

/// What is still to be printed is lost on a full disk, and with it the answer of all commands but those that write a
/// run folder.
int print_the_rest(int status, bool writes_a_run)
{
  errno = 0;
  if (std::fflush(stdout) == 0 || errno == EPIPE || writes_a_run || status != terp::solved) return status;
  fmt::print(stderr, "error: what was to be printed is not complete: {}\n", std::strerror(errno));
  return terp::failed;
}

}  // namespace

int main(int argc, char** argv)
{
  if (!keep_standard_streams()) return terp::failed;  // nobody could be told
  terp::return_large_arrays_when_freed();
  CLI::App app;
  CommandLine line;
  declare(app, line);
  try {
    if (answer_help(argc, argv)) return print_the_rest(terp::solved, false);
    check_command(app, argv[1]);
    app.parse(argc, argv);
    const int status = call(app, line);
    return print_the_rest(status, app.got_subcommand("run") || app.got_subcommand("resume"));
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "error: {}\nUsage: terp COMMAND [options]; see terp --help\n", error.what());
    return terp::bad_input;
  } catch (const terp::CaseError& error) {
    fmt::print(stderr, "{}", error.what());
    return terp::bad_input;
  } catch (const terp::InstructionsError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return terp::bad_input;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "error: not enough memory for this case. `terp check CASE.toml` says how much it needs.\n");
    return terp::failed;
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "error: cannot use {}: {}\n", error.path1().string(), error.code().message());
    return terp::failed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return terp::failed;
  }
}
