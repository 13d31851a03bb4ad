// terp run and terp resume.

#include "commands.hpp"
#include "input/case_file.hpp"
#include "output/checkpoint.hpp"
#include "output/run_writer.hpp"
#include "output/summary_json.hpp"
#include "parallel/threads.hpp"
#include "progress.hpp"
#include "simulation/run.hpp"
#include "simulation/setup.hpp"
#include "simulation/setup_history.hpp"
#include "simulation/state_image.hpp"

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>

namespace terp {
namespace {

std::atomic<bool> stop_requested{false};

/// The first Ctrl-C asks the run to stop after its step; the second ends the program at once.
void request_stop(int signal)
{
  stop_requested.store(true);
  std::signal(signal, SIG_DFL);
}

void listen_for_stop()
{
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

std::string optional_number(const std::optional<Real>& value, const char* unit)
{
  return value ? fmt::format("{:.3g} {}", *value, unit) : std::string("-");
}

void print_summary(const Summary& s, const std::string& folder)
{
  fmt::print("solved in {}: {} points, {} steps of {:.4g} s, {:.1f} M point-steps/s on {} thread{}\n", readable_duration(s.wall_s), s.n_points,
             s.n_steps, s.dt, s.point_steps_per_s / 1e6, s.threads, s.threads == 1 ? "" : "s");
  fmt::print("  front            {:.2f} m\n", s.front_x);
  fmt::print("  crest            {}\n", optional_number(s.crest_x, "m"));
  fmt::print("  second failure   {}\n", optional_number(s.second_failure_time, "s"));
  fmt::print("  largest eps_eq_p {:.3g}\n", s.max_eps_eq_p);
  fmt::print("  energy balance   {:.2g} % of the energy exchanged\n", 100.0 * s.energy_balance_error);
  fmt::print("  points lost: 0; put back at walls: {}; left through open sides: {}\n", s.clamped_points, s.points_left);
  fmt::print("results in {}\n", folder);
}

void print_passes(const Workspace& work)
{
  double total = 0.0;
  for (const double s : work.seconds) total += s;
  for (int pass = 0; pass < n_passes; ++pass)
    fmt::print("  {:<16} {:8.2f} s  {:4.1f} %\n", pass_names[pass], work.seconds[pass], 100.0 * work.seconds[pass] / total);
}

/// Solves, and leaves a summary however the run ends.
int solve(const Model& model, State& state, RunWriter& writer, const RunOptions& options, const std::string& folder)
{
  listen_for_stop();
  ProgressLine progress(options.quiet);
  Observer* const observers[] = {&writer, &progress};
  Workspace work(model, state);
  writer.summary(summarise(model, state), false);  // also names the case for `resume`
  try {
    const Outcome outcome = run(model, state, work, observers, stop_requested);
    progress.finish();
    const Summary summary = summarise(model, state);
    writer.summary(summary, outcome == Outcome::finished);
    if (outcome == Outcome::interrupted) {
      fmt::print("stopped at t = {:.4g} s, step {}; a checkpoint is written. Go on with:\n  terp resume {}\n", state.time, state.step, folder);
      return failed;
    }
    if (!options.quiet) print_summary(summary, folder);
    if (options.verbose) print_passes(work);
    return solved;
  } catch (const RunError& error) {
    progress.finish();
    fmt::print(stderr, "error: {}\n", error.what());
    writer.summary(summarise(model, state), false);
    return stopped_itself;
  }
}

int threads_of(const RunOptions& options) { return options.threads > 0 ? options.threads : available_processors(); }

/// A run folder, from a folder or from the path of one of its checkpoints.
std::string run_folder_of(const std::string& path)
{
  std::filesystem::path p(path);
  if (std::filesystem::is_regular_file(p)) p = p.parent_path();
  return p.empty() ? "." : p.string();
}

/// The checkpoint that was named, or the newest good one of the folder.
StateImage find_checkpoint(const std::string& path)
{
  if (std::filesystem::is_regular_file(path)) return read_checkpoint(path);
  CheckpointSearch found = newest_good_checkpoint(path);
  for (const auto& bad : found.skipped) fmt::print(stderr, "warning: skipped {}: {}\n", bad.path, bad.reason);
  if (!found.image) throw FileError(fmt::format("{}: no checkpoint to resume from. Start the case anew with `terp run`.", path));
  return std::move(*found.image);
}

}  // namespace

int run_case(const RunOptions& options)
{
  const CaseFile file = read_case(options.path, options.changes);
  fmt::print(stderr, "{}", render_warnings(file));
  try {
    Model model = build_model(file.values, threads_of(options));
    State state = build_state(model);
    fmt::print(stderr, "{}", render_warnings(find_far_history_points(model, state), file));
    const std::string folder = options.output.empty() ? "runs/" + file.values.name : options.output;
    const auto writer = RunWriter::start({folder, {file.values.name, file.text}, file.values.output.checkpoint_keep}, options.force);
    return solve(model, state, *writer, options, folder);
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
}

int resume_run(const RunOptions& options)
{
  const std::string folder = run_folder_of(options.path);
  if (!std::filesystem::is_directory(folder)) throw FileError(fmt::format("{}: no such run folder", options.path));
  CaseFile file = read_case(path_in(folder, case_file));
  const StateImage image = find_checkpoint(options.path);
  Model model = build_model(file.values, threads_of(options));
  build_state(model);  // names the history points
  State state = restore(model, image);
  const std::string name = case_name_in(folder);
  const auto writer = RunWriter::resume({folder, {name, file.text}, file.values.output.checkpoint_keep}, image.step, image.time);
  if (!options.quiet) fmt::print("resuming {} at t = {:.4g} s, step {} of {}\n", folder, state.time, state.step, model.n_steps);
  return solve(model, state, *writer, options, folder);
}

}  // namespace terp
