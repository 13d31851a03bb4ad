#include "cli/started_run.hpp"

#include "cli/cost.hpp"
#include "io/case/printable.hpp"
#include "io/files/checkpoint.hpp"
#include "model/soils/softening_scales.hpp"
#include "mpm/step/passes.hpp"
#include "mpm/step/workspace.hpp"
#include "os/say.hpp"
#include "os/stop.hpp"
#include "model/parts/initial.hpp"
#include "run/loop/stages.hpp"
#include "run/rest/no_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

std::string optional_number(const std::optional<Real>& value, const char* unit)
{
  return value ? fmt::format("{:.3g} {}", *value, unit) : std::string("-");
}

void print_summary(const Summary& s, const Model& model, const std::string& folder)
{
  say("solved in {}: {} points, {} steps of {:.4g} s, {:.1f} M point-steps/s on {} thread{}\n",
      readable_duration(s.wall_s), s.n_points, s.n_steps, s.dt, s.point_steps_per_s / 1e6, s.threads,
      s.threads == 1 ? "" : "s");
  if (s.search_steps > 0)
    say("  equilibrium      found in {} steps, {} of that time\n", s.search_steps, readable_duration(s.search_s));
  if (s.at_strength != 1.0) say("  strengths        divided by {:g}\n", s.at_strength);
  if (s.flood) say("  water            {}\n                   {}\n", flood_clause(*s.flood) + '.', flood_caution);
  if (s.flood && s.flood->ravelled_volume.value_or(0.0) > 0.0)
    say("  ravelled         {:.1f} m^2, from at most {:.1f} m below the ground\n", *s.flood->ravelled_volume,
        s.flood->ravelled_depth.value_or(0.0));
  say("  front            {}\n", std::isfinite(s.front_x) ? fmt::format("x = {:.2f} m", s.front_x) : "-");
  say("  crest            {}\n", s.crest_x ? fmt::format("x = {:.2f} m", *s.crest_x) : "-");
  say("  second failure   {}\n", optional_number(s.second_failure_time, "s"));
  if (s.max_eps_eq_p) say("  largest eps_eq_p {:.3g}\n", *s.max_eps_eq_p);
  const Real most = s.max_eps_eq_p.value_or(0.0);
  if (softens_point_by_point(model) && most > s.softened_strain.value_or(most))
    say("  softening        no length, no reference width: the result depends on the cells (docs/convergence.md)\n");
  say("  energy balance   {:.2g} % of the energy from outside is unexplained\n", 100.0 * s.unexplained_energy);
  for (const FootingSummary& f : s.footings)
    say("  {:<16} reaction {:.4g} kN/m, {:.4g} kN/m up, at the end; largest against its motion {:.4g} kN/m\n",
        printable(f.name), f.reaction[0] / 1e3, f.reaction[1] / 1e3, f.largest / 1e3);
  for (const StageSummary& stage : s.stages) {
    const StageRecord& r = stage.record;
    say("  {:<16} {:.4g} to {:.4g} s, {} steps{}\n", stage.name.empty() ? "end" : "stage " + stage.name, r.start, r.end,
        r.steps,
        r.known_for > 0.0          ? ", " + why_known(r)
        : r.at_rest                ? std::string(", at rest")
        : std::isfinite(r.fastest) ? fmt::format(", not at rest: fastest node {:.2g} m/s", r.fastest)
                                   : "");
  }
  say("  points lost: 0; put back at walls: {}; left through open sides: {}\n", s.clamped_points, s.points_left);
  say("results in {}\n", folder);
}

std::string resume_command(const std::string& folder, const RunOptions& options)
{
  return fmt::format("terp resume {}{}", folder, options.report ? " --report" : "");
}

/// What to do when a file of the run cannot be written; earlier results are as they were.
std::string hint_to_go_on(const std::string& folder, const RunOptions& options)
{
  try {
    const CheckpointSearch found = newest_good_checkpoint(folder);
    if (!found.image)
      return "\n  No checkpoint was written yet. Make room on the disk, or mend what is told above, then give the same "
             "command with --force.";
    return fmt::format(
        "\n  Earlier results are intact, up to the checkpoint at t = {:.4g} s. Make room on the disk, or mend what is "
        "told above, then go on with:\n  {}",
        found.image->time, resume_command(folder, options));
  } catch (const FileError&) {
    return "";  // the folder is gone
  }
}

bool has_failed_library(const Model& model)
{
  return std::ranges::any_of(model.materials, [](const SoilMaterial& soil) { return !soil.law->fault().empty(); });
}

/// How to go on with a corrected library or case.
std::string hint_for_library(const std::string& folder)
{
  const CheckpointSearch found = newest_good_checkpoint(folder);
  if (!found.image) return "  left     no checkpoint was written yet: begin anew with the corrected library or case";
  return fmt::format(
      "  left     the checkpoint at t = {:.4g} s; with a corrected library or case go on from it:\n"
      "           terp run CASE.toml --from {} -o NEW_FOLDER (docs/user_laws.md#when-the-law-fails)",
      found.image->time, folder);
}

}  // namespace

void StartedRun::write_to(std::unique_ptr<RunWriter> writer)
try {
  writer_ = std::move(writer);
  listen_for_stop();
  mesh_.emplace(folder_, writer_->frames_of_mesh(), simulation.model, simulation.state);
  keeper_.emplace(simulation.model, simulation.state, *writer_);
  simulation.observers = {writer_.get(), &*mesh_, &*keeper_, &progress_};
  if (part().observer != nullptr) simulation.observers.push_back(part().observer);
  writer_->summary(summarise(simulation.model, simulation.state), false);  // also names the case for `resume`
} catch (const FileError& error) {
  throw FileError(error.what() + hint_to_go_on(folder_, options_));
}

std::optional<int> StartedRun::go_on(Real until)
try {
  const Outcome outcome = has_started(simulation.state) || std::isinf(until) ? simulation.run(stop_requested, until)
                                                                             : simulation.start(stop_requested);
  if (outcome == Outcome::interrupted) return stop();
  const bool is_through = simulation.model.stage.is_last() && has_ended(simulation.model, simulation.state);
  return is_through ? std::optional(end()) : std::nullopt;
} catch (const RunError& error) {
  return end_with(error);
} catch (const FileError& error) {
  progress_.finish();
  throw FileError(error.what() + hint_to_go_on(folder_, options_));
} catch (const InputError& error) {
  throw CaseError(render(error.problems(), file_));
}

int StartedRun::stop()
{
  const State& state = simulation.state;
  progress_.finish();
  write_summary(false);
  if (is_alone(options_))
    say("stopped at t = {:.4g} s, step {}; a checkpoint is written. Go on with:\n  {}\n", state.time, state.step,
        resume_command(folder_, options_));
  return failed;
}

Summary StartedRun::write_summary(bool is_through)
{
  Summary summary = summarise(simulation.model, simulation.state);
  for (int pass = 0; pass < n_passes; ++pass)
    summary.passes.push_back({pass_names[pass], simulation.work.seconds[pass]});
  writer_->summary(summary, is_through);
  return summary;
}

int StartedRun::end()
{
  const Model& model = simulation.model;
  progress_.finish();
  const Summary summary = write_summary(true);
  if (!options_.quiet && is_alone(options_)) print_summary(summary, model, folder_);
  for (const RunFinding& finding : summary.findings)
    say(stderr, "warning: {}: {} See {}\n", folder_, printable(finding.en), finding.see);
  if (const std::string overload = describe_overload(model, simulation.state); !overload.empty())
    say(stderr, "warning: {}: {}\n", folder_, overload);
  if (options_.at_end) options_.at_end(simulation);
  if (options_.verbose) print_passes(simulation.work);
  if (options_.report)
    report_runs({.runs = {folder_}, .output = path_in(folder_, report_file), .language = options_.language});
  return solved;
}

int StartedRun::end_with(const RunError& error)
{
  progress_.finish();
  const PartOfSet set = part();
  if (set.fault != nullptr) *set.fault = error.what();
  if (set.slides != nullptr) *set.slides = dynamic_cast<const SlidesAsDrawn*>(&error) != nullptr;
  if (is_alone(options_)) say(stderr, "error: {}\n", error.what());
  writer_->summary(summarise(simulation.model, simulation.state), false);
  if (is_alone(options_) && has_failed_library(simulation.model)) say(stderr, "{}\n", hint_for_library(folder_));
  return stopped_itself;
}

}  // namespace terp
