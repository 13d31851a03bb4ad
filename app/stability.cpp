// terp stability: the factor of safety by strength reduction.

#include "commands.hpp"
#include "input/case_file.hpp"
#include "input/printable.hpp"
#include "output/files.hpp"
#include "output/stability_json.hpp"
#include "progress.hpp"
#include "stop.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

namespace terp {
namespace {

/// One line per trial, renewed after each window on a terminal.
class TrialLine {
 public:
  explicit TrialLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

  void show(const Trial& trial, const StabilityResult& so_far, int trials_left)
  {
    const bool ended = !trial.reason.empty();
    if (quiet_ || (!terminal_ && !ended)) return;
    longest_ = std::max(longest_, trial.wall_s);
    const std::string start = terminal_ ? "\r\033[K" : "";
    if (ended) return terp::show(stderr, fmt::format("{}factor {:.4f}  {}\n", start, trial.factor, trial.reason));
    const TrialWindow& w = trial.windows.back();
    terp::show(stderr,
        fmt::format("{}factor {:.4f}  t = {:.3g} s  displacement {:.2f} rho g H^2/E  out of balance {:.1e}  ETA {}",
            start, trial.factor, w.time, w.displacement / so_far.displacement, w.out_of_balance,
            readable_duration(longest_ * trials_left + longest_ - trial.wall_s)));
  }

 private:
  bool quiet_, terminal_;
  double longest_ = 0.0;  // trial so far [s]
};

void check_options(const BisectionOptions& o)
{
  if (o.from && o.to && !(*o.from < *o.to))
    throw CaseError(
        fmt::format("error: --from {:g} --to {:g}: the first must be the smaller one\n  --from is a factor at which "
                    "the soil is believed to stand, "
                    "--to one at which it is not.\n",
            *o.from, *o.to));
}

void warn_of_motion(const Case& c)
{
  if (!c.footings.empty())
    fmt::print(stderr, "warning: terp stability leaves footings out: the soil carries its own weight alone\n");
  for (const SideCondition& side : c.sides)
    if (is_driven(side))
      fmt::print(stderr, "warning: the side `{}` stands still in terp stability\n", printable(side.side));
}

}  // namespace

int find_stability(const RunOptions& run, StabilityOptions options)
{
  check_options(options.search);
  const CaseFile file = read_case(run.path, run.changes);
  const std::string folder = run.output.empty() ? default_run_folder(run.path) : run.output;
  fmt::print(stderr, "{}", render_warnings(file));
  warn_of_motion(file.values);
  options.threads = threads_of(run);
  listen_for_stop();
  try {
    const std::string& scheme = file.values.scheme;
    make_folder(folder);  // before the trials, which take long
    TrialLine line(run.quiet || run.json);
    int granted = options.threads;
    const auto show = [&](const Trial& trial, const StabilityResult& so_far, int trials_left) {
      if (trial.threads < granted) warn_of_missing_threads(run, granted = trial.threads);
      line.show(trial, so_far, trials_left);
    };
    const StabilityResult result = find_factor_of_safety(file.values, options, stop_requested, show);
    const CaseText text{file.values.name, file.text};
    if (run.json)
      fmt::print("{}", stability_json(result, scheme, text));
    else if (!run.quiet || !result.search.found())
      fmt::print("{}", stability_text(result, scheme));
    write_stability(folder, result, scheme, text);
    copy_inputs(file.inputs, folder);
    if (!run.quiet && !run.json) fmt::print("results in {}\n", folder);
    return result.search.found() && !result.stopped ? solved : failed;
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  } catch (const RunError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return stop_requested.load() ? failed : stopped_itself;
  }
}

}  // namespace terp
