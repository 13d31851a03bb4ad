// The case is read for all cell sizes before the first search, so that a size that does not work is found early. The
// searches go from coarse to fine cells. Each begins near the result of the one before, lower by what finer cells
// usually take off. Factors gather in one list, which each result takes along: the last one, in the folder itself, has
// all sizes.

#include "math/checksum.hpp"
#include "cli/commands.hpp"
#include "io/case/case_file.hpp"
#include "io/case/cell_size.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "io/files/mechanism_files.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/stability_json.hpp"
#include "cli/progress.hpp"
#include "os/stop.hpp"
#include "run/findings/setup_warnings.hpp"
#include "run/loop/run.hpp"
#include "os/say.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

/// One line per trial, renewed after each window on a terminal.
class TrialLine {
 public:
  explicit TrialLine(bool quiet) : quiet_(quiet) {}

  void show(const Trial& trial, const StabilityResult& so_far, int trials_left)
  {
    const bool ended = !trial.reason.empty();
    if (quiet_ || (!line_.renews() && !ended)) return;
    longest_ = std::max(longest_, trial.wall_s);
    if (ended) {
      line_.show(fmt::format("factor {:.4f}  {}", trial.factor, trial.reason));
      return line_.end();
    }
    const TrialWindow& w = trial.windows.back();
    line_.show(
        fmt::format("factor {:.4f}  t = {:.3g} s  displacement {:.2f} rho g H^2/E  out of balance {:.1e}  ETA {}",
            trial.factor, w.time, w.displacement / so_far.displacement, w.out_of_balance,
            readable_duration(longest_ * trials_left + longest_ - trial.wall_s)));
  }

 private:
  bool quiet_;
  LiveLine line_{stderr};
  double longest_ = 0.0;  // trial so far [s]
};

void check_options(const BisectionOptions& o)
{
  if (o.from && o.to && !(*o.from < *o.to))
    throw CaseError(
        fmt::format("error: --from {:g} --to {:g}: the first must be the smaller one\n  --from is a factor at which "
                    "the soil is believed to stand, --to one at which it is not.\n",
            *o.from, *o.to));
}

void warn_of_motion(const Case& c, const std::string& folder)
{
  if (!c.footings.empty())
    say(stderr, "warning: {}: terp stability leaves footings out: the soil carries its own weight alone\n", folder);
  for (const SideCondition& side : c.sides)
    if (is_driven(side))
      say(stderr, "warning: {}: the side `{}` stands still in terp stability\n", folder, printable(side.side));
}

void warn_of_limited_tension(const Case& c, const std::string& folder)
{
  if (const auto soils = soils_that_limit_tension(c); !soils.empty())
    say(stderr, "warning: {}: --with-tension has no effect on `{}`: the case limits the tension by tension_cutoff\n",
        folder, printable(fmt::format("{}", fmt::join(soils, "`, `"))));
}

/// What `terp check` and `terp run` say of the section; not of outputs, the verdict and what the search leaves out.
void warn_of_section(const CaseFile& file)
{
  constexpr std::string_view of_runs[] = {"output", "history", "flood", "footing", "time", "forces.damping"};
  const auto is_of_run = [&](const Problem& p) {
    return std::ranges::any_of(of_runs, [&](std::string_view key) { return p.key.starts_with(key); });
  };
  try {
    const Simulation section(file.values, 1);
    std::vector<Problem> warnings = find_warnings(section.model, section.state);
    std::erase_if(warnings, is_of_run);
    say(stderr, "{}", render_warnings(warnings, file));
  } catch (const InputError&) {  // the search says so, or does not need what a run does
  }
}

/// cell: [m]; 0: as it is.
CaseFile read_sized(const RunOptions& run, const CaseFile& as_given, double cell)
{
  std::vector<std::string> changes = run.changes;
  if (cell > 0.0)
    for (std::string& change : changes_to_cell_size(as_given, cell)) changes.push_back(std::move(change));
  return read_case(run.path, changes);
}

/// Width of the brackets of searches that are extrapolated, as a part of the factor.
constexpr Real narrow = 0.005;

/// Looks on finer cells just below what coarser ones gave.
void look_nearby(const StabilityResult& coarser, BisectionOptions& search)
{
  constexpr Real fall = 0.94;  // when cells are halved: usual, 1 to 7 % on known slopes
  if (!coarser.search.found()) return;
  search.from = fall * *coarser.search.stable;
  search.to = coarser.search.highest();
}

StabilityResult search_and_write(const RunOptions& run, const CaseFile& file, const StabilityOptions& options,
    const std::string& folder, std::vector<SizedFactor>& sizes, bool is_last = true)
{
  make_folder(folder);  // before the trials, which take long
  const FolderLock lock(folder);
  if (!run.force && std::filesystem::exists(path_in(folder, "stability.json")))
    throw FileError(fmt::format(
        "the folder {} holds the result of an earlier search\n  Use --force to replace it, or -o DIR to write "
        "to another folder.",
        folder));
  TrialLine line(run.quiet || run.json);
  int granted = options.threads;
  const auto show = [&](const Trial& trial, const StabilityResult& so_far, int trials_left) {
    if (trial.threads < granted) warn_of_missing_threads(run, granted = trial.threads);
    line.show(trial, so_far, trials_left);
  };
  StabilityResult result = find_factor_of_safety(file.values, options, stop_requested, show);
  if (result.search.found() && !result.stopped) sizes.push_back(size_of(result));
  if (options.cracks && is_last && !result.stopped)
    result.with_tension = find_factor_with_tension(file.values, result, stop_requested, show);
  result.sizes = sizes;
  const CaseText text{file.values.name, file.text};
  write_stability(folder, result, file.values.scheme, text);
  write_mechanism(folder, quiet_case(judged_case(file.values, options)), result, digits_of(file.text));
  copy_inputs(file.inputs, folder);
  return result;
}

}  // namespace

StabilityResult search_stability(const RunOptions& run, StabilityOptions options)
{
  const CaseFile file = read_case(run.path, run.changes);
  options.threads = threads_of(run);
  options.cracks = true;
  listen_for_stop();
  std::vector<SizedFactor> sizes;
  try {
    RunOptions own = run;
    own.force = true;  // the folder is that of the command that asks
    return search_and_write(own, file, options, run.output, sizes);
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
}

int find_stability(const RunOptions& run, StabilityOptions options, const std::vector<double>& cells)
{
  check_options(options.search);
  CaseFile given = read_case(run.path, run.changes);
  const std::string folder = run.output.empty() ? default_run_folder(run.path) : run.output;
  given.run = folder;
  say(stderr, "{}", render_warnings(given));
  warn_of_motion(given.values, folder);
  if (!options.cracks) warn_of_limited_tension(given.values, folder);
  options.threads = threads_of(run);
  listen_for_stop();
  const std::vector<double> todo = cells.empty() ? std::vector<double>{0.0} : descending_sizes(cells);
  std::vector<CaseFile> files;
  for (const double cell : todo) files.push_back(read_sized(run, given, cell));
  files.back().run = folder;
  warn_of_section(files.back());
  std::vector<SizedFactor> sizes;
  StabilityResult result;
  if (todo.size() > 1) options.search.relative_tolerance = narrow;  // differences of the factors are extrapolated
  for (std::size_t k = 0; k < todo.size(); ++k) {
    const CaseFile& file = files[k];
    const bool last = k + 1 == todo.size();
    try {
      if (k > 0) look_nearby(result, options.search);
      if (todo.size() > 1 && !run.quiet && !run.json) say(stderr, "cells of {:g} m\n", todo[k]);
      result = search_and_write(
          run, file, options, last ? folder : path_in(folder, fmt::format("cells_{:g}", todo[k])), sizes, last);
    } catch (const InputError& error) {
      throw CaseError(render(error.problems(), file));
    } catch (const RunError& error) {
      say(stderr, "error: {}\n", error.what());
      return stop_requested.load() ? failed : stopped_itself;
    }
    if (result.stopped) break;
  }
  const std::string& scheme = given.values.scheme;
  if (run.json)
    say("{}", stability_json(result, scheme, {files.back().values.name, files.back().text}));
  else if (!run.quiet || !result.search.found())
    say("{}", stability_text(result, scheme));
  if (!run.quiet && !run.json) say("results in {}\n", folder);
  return result.search.found() && !result.stopped ? solved : failed;
}

}  // namespace terp
