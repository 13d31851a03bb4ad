// Help and version are answered before CLI11 reads the line, so that they work beside an error on it. The first word is
// tested before CLI11, too, for a message with the nearest command. Then one command is called and returns its status;
// what it throws becomes a message and a status. At the end stdout is flushed: only then is it known whether
// the answer was written.

#include "cli/program.hpp"

#include "math/closest.hpp"
#include "io/case/case_file.hpp"
#include "io/case/explain.hpp"
#include "io/case/printable.hpp"
#include "os/instructions.hpp"
#include "os/memory.hpp"
#include "page/page.hpp"
#include "batch/reliability.hpp"
#include "os/terminal.hpp"
#include "os/say.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace {

void check_command(const CLI::App& app, const std::string& word)
{
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (word.starts_with('-')) {
    const std::string nearest = terp::closest(word, {"--version", "--help", "-h"});
    throw terp::CaseError(
        terp::printable(fmt::format("error: there is no option `{}` before a command\n{}"
                                    "  Commands: {}\nUsage: terp COMMAND [options]; see terp --help\n",
            word, nearest.empty() ? "" : fmt::format("  Did you mean `{}`?\n", nearest), fmt::join(names, ", "))));
  }
  if (std::ranges::find(names, word) != names.end()) return;
  std::string hint;
  if (const std::string nearest = terp::closest(word, names); !nearest.empty())
    hint = fmt::format("  Did you mean `{}`?\n", nearest);
  if (word.ends_with(".toml")) hint = fmt::format("  To solve that case: terp run {}\n", word);
  const std::string message =
      fmt::format("error: there is no command `{}`\n{}  Commands: {}\n", word, hint, fmt::join(names, ", "));
  throw terp::CaseError(terp::printable(message + "Usage: terp COMMAND [options]; see terp --help\n"));
}

#ifdef __clang__
constexpr const char* compiler = __VERSION__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

/// The version and the instructions in use; then what this program was built with.
std::string version_text()
{
  std::vector<std::string_view> sets;
  for (const terp::InstructionSet& set : terp::instruction_sets()) sets.push_back(set.name);
  const auto known = [](bool there) { return there ? "yes" : "no"; };
  return fmt::format(
      "terp {} ({})\n  compiler       {}\n  instructions   {}\n  report page    {}\n  OpenTURNS      {}\n",
      TERP_VERSION, terp::instructions(), compiler, fmt::join(sets, ", "), known(terp::has_page()),
      known(terp::has_openturns()));
}

/// Help and version are answered wherever they stand on the line; help on a command if it begins with one.
bool answer_help(const CLI::App& app, int argc, char** argv)
{
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (k == 1 && word == "help") return terp::say("{}", terp::help_on(app, argc > 2 ? argv[2] : "")), true;
    if (word == "-h" || word == "--help") return terp::say("{}", terp::help_on(app, argv[1])), true;
    if (word == "--version") return terp::say("{}", version_text()), true;
  }
  if (argc == 1) terp::say("{}", terp::help_on(app, ""));
  return argc == 1;
}

/// What cannot be printed is lost, on a full disk say, and with it the answer of a command that writes no files.
int print_the_rest(int status, bool writes_files)
{
  const int why = terp::why_output_is_lost();
  if (why == 0 || why == EPIPE || writes_files || status != terp::solved) return status;
  terp::say(stderr, "error: what was to be printed is not complete: {}\n", std::strerror(why));
  return terp::failed;
}

/// Whether the answer is in files, and what is printed only tells of them.
bool writes_files(const CLI::App& app, const terp::CommandLine& line)
{
  return std::ranges::any_of(
             std::initializer_list<const char*>{"run", "resume", "converge", "study", "report", "export", "assess"},
             [&](const char* name) { return app.got_subcommand(name); }) ||
         !line.imported.output.empty();
}

}  // namespace

namespace terp {

int call_command(const CLI::App& app, const CommandLine& line)
{
  if (app.got_subcommand("run")) return run_case(line.options);
  if (app.got_subcommand("resume")) return resume_run(line.options);
  if (app.got_subcommand("stability")) return find_stability(line.options, line.stability, line.stability_cells);
  if (app.got_subcommand("converge")) return converge_case(line.converge);
  if (app.got_subcommand("study")) return study_case(line.study);
  if (app.got_subcommand("seepage")) return compute_seepage(line.seepage);
  if (app.got_subcommand("element")) return test_elements(line.element);
  if (app.got_subcommand("check")) return check_case(line.options);
  if (app.got_subcommand("report")) return report_runs(line.report);
  if (app.got_subcommand("compare")) return compare_folders(line.report);
  if (app.got_subcommand("export")) return export_run(line.exported);
  if (app.got_subcommand("import")) return import_file(line.imported);
  if (app.got_subcommand("assess")) return assess_reach(line.assess);
  if (app.got_subcommand("watch")) return watch_run(line.watch);
  if (app.got_subcommand("bench")) return bench_case(line.options);
  if (app.got_subcommand("schema")) return say("{}", case_schema()), solved;
  say("{}", app.got_subcommand("explain") ? explain(line.topic) : list());
  return solved;
}

int status_of(const std::function<int()>& call)
{
  try {
    return call();
  } catch (const CaseError& error) {
    say(stderr, "{}", error.what());
    return bad_input;
  } catch (const InstructionsError& error) {
    say(stderr, "error: {}\n", error.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    say(stderr, "error: not enough memory for this case. `terp check CASE.toml` says how much it needs.\n");
    return failed;
  } catch (const std::filesystem::filesystem_error& error) {
    say(stderr, "error: cannot use {}: {}\n", error.path1().string(), error.code().message());
    return failed;
  } catch (const std::exception& error) {
    say(stderr, "error: {}\n", error.what());
    return failed;
  }
}

int answer(int argc, char** argv, const Command& call)
{
  if (!prepare_standard_streams()) return failed;  // nobody could be told
  return_large_arrays_when_freed();
  CLI::App app;
  CommandLine line;
  declare(app, line);
  return status_of([&] {
    if (answer_help(app, argc, argv)) return print_the_rest(solved, false);
    check_command(app, argv[1]);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      throw CaseError(printable(describe(app, error)));
    }
    const int status = call(app, line);
    return print_the_rest(status, writes_files(app, line));
  });
}

}  // namespace terp
