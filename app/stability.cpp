// terp stability: the factor of safety by strength reduction.

#include "commands.hpp"
#include "input/case_file.hpp"
#include "input/printable.hpp"
#include "output/stability_json.hpp"
#include "parallel/threads.hpp"
#include "progress.hpp"
#include "simulation/setup_mesh.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <unistd.h>

namespace terp {
namespace {

std::atomic<bool> stop_requested{false};

void request_stop(int signal)
{
  stop_requested.store(true);
  std::signal(signal, SIG_DFL);
}

/// One line per trial, renewed after each window on a terminal.
class TrialLine {
 public:
  TrialLine(bool quiet, const ElasticStart& start, const TrialRules& rules)
      : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), displacement_(start.displacement), most_windows_(rules.most_windows)
  {
  }

  void show(const Trial& trial, int trials_left)
  {
    const bool ended = trial.verdict != Verdict::undecided || std::ssize(trial.windows) == most_windows_ || trial.windows.empty();
    if (quiet_ || (!terminal_ && !ended)) return;
    if (ended) {
      mean_wall_ += (trial.wall_s - mean_wall_) / static_cast<double>(++n_ended_);
      fmt::print(stderr, "{}factor {:.4f}  {}\n", start_of_line(), trial.factor, trial.reason);
      return;
    }
    const TrialWindow& w = trial.windows.back();
    const double eta = std::max(mean_wall_, trial.wall_s) * trials_left;
    fmt::print(stderr, "{}factor {:.4f}  t = {:.3g} s  displacement {:.2f} rho g H^2/E  out of balance {:.1e}  ETA {}", start_of_line(), trial.factor, w.time,
               w.displacement / displacement_, w.out_of_balance, readable_duration(eta));
    std::fflush(stderr);
  }

 private:
  const char* start_of_line() const { return terminal_ ? "\r\033[K" : ""; }

  bool quiet_, terminal_;
  Real displacement_;
  Index most_windows_;
  double mean_wall_ = 0.0;
  int n_ended_ = 0;
};

void check_options(const StabilityOptions& o)
{
  if (o.from && o.to && !(*o.from < *o.to))
    throw CaseError(fmt::format("error: --from {:g} --to {:g}: the first must be the smaller one\n  --from is a factor at which the soil is believed to stand, "
                                "--to one at which it is not.\n",
                                *o.from, *o.to));
}

Bisection search_factor(const Case& quiet, const Mesh<2>& mesh, const ElasticStart& start, const StabilityOptions& o, const TrialRules& rules, int threads)
{
  const BisectionOptions options{o.from, o.to, o.tolerance};
  Bisection search;
  TrialLine line(o.run.quiet || o.run.json, start, rules);
  while (const auto factor = next_factor(search, options)) {
    if (const auto faults = check_reduced(reduce_strength(quiet, *factor)); !faults.empty())
      throw CaseError(fmt::format("error: at the factor {:g} the strengths are not usable\n  {}\n  Choose --from and --to nearer to the answer.\n", *factor,
                                  printable(faults.front())));
    const int left = trials_left(search, options);
    Trial trial = run_trial(quiet, mesh, start, *factor, rules, threads, stop_requested, [&](const Trial& t) { line.show(t, left); });
    if (trial.windows.empty()) line.show(trial, left);
    enter(std::move(trial), search);
  }
  return search;
}

void warn_of_motion(const Case& c)
{
  if (!c.footings.empty()) fmt::print(stderr, "warning: terp stability leaves footings out: the soil carries its own weight alone\n");
  for (const SideCase& side : c.sides)
    if (side.kind == SideKind::velocity) fmt::print(stderr, "warning: the side `{}` stands still in terp stability\n", printable(side.side));
}

std::int64_t points_of(const ElasticStart& start) { return start.rest.arrays.empty() ? 0 : std::get<std::vector<std::int64_t>>(start.rest.arrays[0].values).size(); }

}  // namespace

int find_stability(const StabilityOptions& o)
{
  check_options(o);
  const CaseFile file = read_case(o.run.path, o.run.changes);
  fmt::print(stderr, "{}", render_warnings(file));
  warn_of_motion(file.values);
  const int threads = o.run.threads > 0 ? o.run.threads : available_processors();
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  try {
    const Case quiet = quiet_case(file.values);
    StabilityReport report{.case_name = file.values.name, .case_toml = file.text, .scheme = quiet.scheme, .strengths = strengths_of(quiet),
                           .rules = {.damping = o.damping, .rest = o.rest, .failure = o.failure, .most_windows = o.windows},
                           .options = {o.from, o.to, o.tolerance},
                           .search = {}};
    if (report.strengths.empty())
      throw CaseError(fmt::format("error: {}: no material of this case has a strength to reduce\n  Laws with one: see `terp explain tresca_softening`.\n",
                                  printable(o.run.path)));
    const Mesh<2> mesh = build_mesh(quiet);
    const ElasticStart start = settle_elastically(quiet, mesh, threads, stop_requested);
    report.height = start.height;
    report.displacement = start.displacement;
    report.rest_steps = start.steps;
    report.n_points = points_of(start);
    report.search = search_factor(quiet, mesh, start, o, report.rules, threads);
    const std::string folder = o.run.output.empty() ? "runs/" + file.values.name : o.run.output;
    write_stability(folder, report);
    if (o.run.json)
      fmt::print("{}", stability_json(report));
    else if (!o.run.quiet)
      fmt::print("{}results in {}\n", stability_text(report), folder);
    return report.search.found() ? solved : failed;
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  } catch (const RunError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return stop_requested.load() ? failed : stopped_itself;
  }
}

}  // namespace terp
