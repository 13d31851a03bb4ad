// A request to stop is read between steps, so a checkpoint is always of a whole step. After a step the guards look
// first; then rest and the end of the stage are entered, so that the outputs know whether the step ends the stage.

#include "run/loop/run.hpp"

#include "math/errors.hpp"
#include "mpm/features/rest.hpp"
#include "mpm/step/stored_energy.hpp"
#include "mpm/step/workspace.hpp"
#include "os/instructions.hpp"
#include "run/rest/equilibrium.hpp"
#include "run/loop/guards.hpp"
#include "model/parts/initial.hpp"
#include "run/report/ledger.hpp"
#include "model/loads/loads.hpp"
#include "model/water/carried_water.hpp"
#include "run/rest/no_equilibrium.hpp"
#include "run/loop/placed_bodies.hpp"
#include "run/loop/reporter.hpp"
#include "model/parts/setup.hpp"
#include "run/loop/stages.hpp"
#include "run/report/state_image.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool may_end_early(const StageCase& stage) { return stage.until != Until::end; }

constexpr double progress_every = 0.25;  // of wall time [s]

struct Loop {
  const Model& model;
  State& state;
  Reporter reporter;
  Clock::time_point start = Clock::now();
  double last_progress = -progress_every;
  double wall_before = state.wall_s;
  std::int64_t first_step = state.step;
  double searched = 0.0;  // for equilibrium, in this process [s]

  void report_due(bool last)
  {
    state.wall_s = wall_before + seconds_since(start);
    if (const std::string fault = reporter.report_due(last); !fault.empty()) reporter.stop_run(fault);
  }

  void report_checkpoint()
  {
    state.wall_s = wall_before + seconds_since(start);
    reporter.report_checkpoint();
  }

  void report_search(const SearchProgress& so_far)
  {
    const double wall = seconds_since(start);
    if (wall - last_progress < progress_every) return;
    last_progress = wall;
    const InitialCase& initial = model.description.initial;
    const auto done = static_cast<double>(so_far.steps);
    const auto more = static_cast<double>(so_far.more_steps.value_or(initial.max_steps - so_far.steps));
    reporter.report({.time = 0.0,
        .end_time = model.description.time.end,
        .step = so_far.steps,
        .n_steps = initial.max_steps,
        .n_points = state.points.n_points(),
        .wall_s = wall,
        .point_steps_per_s = done * static_cast<double>(state.points.n_points()) / wall,
        .eta_s = wall / done * more,
        .out_of_balance = so_far.out_of_balance,
        .limit = initial.limit,
        .at_most = !so_far.more_steps});
  }

  void report_progress(bool last)
  {
    const double wall = seconds_since(start);
    if (!last && wall - last_progress < progress_every) return;
    last_progress = wall;
    const auto done = static_cast<double>(state.step - first_step);
    const double of_steps = wall - searched;
    const double rate = of_steps > 0.0 ? done * static_cast<double>(state.points.n_points()) / of_steps : 0.0;
    const std::int64_t end = last_step_of_run(model, state);
    const double eta = done > 0.0 ? of_steps / done * static_cast<double>(end - state.step) : 0.0;
    const Real end_time = end == model.n_steps ? model.description.time.end : model.time_of(end);
    const auto& stages = model.description.stages;
    const auto present = stages.begin() + static_cast<std::ptrdiff_t>(std::min(model.stage.number, stages.size()));
    const bool at_most = std::any_of(present, stages.end(), may_end_early) || model.stage.rest.steps > 0;
    reporter.report({.time = state.time,
        .end_time = end_time,
        .step = state.step,
        .n_steps = end,
        .n_points = state.points.n_points(),
        .wall_s = wall,
        .point_steps_per_s = rate,
        .eta_s = eta,
        .at_most = at_most,
        .stage = model.stage.name});
  }
};

/// What comes before the first step; reached: the first step may be made.
Search start_run(const Model& model, State& state, const std::atomic<bool>& stop, Loop& loop)
{
  if (model.description.initial.stress == InitialStress::equilibrium) {
    Search search =
        find_equilibrium(model, state, stop, [&](const SearchProgress& so_far) { loop.report_search(so_far); });
    loop.searched = seconds_since(loop.start);
    state.search_s += loop.searched;
    if (!search.reached) return search;
    start_soil(model, state);
    if (const auto wrong = find_wrong_start(model, state, [](std::size_t) { return true; }))
      return {.fault = fmt::format("{}: {}\n  {}", wrong->key, wrong->what, wrong->detail)};
  }
  start_followers(model, state);
  state.start_energy = kinetic_and_stored_energy(model, state);
  return {.reached = true};
}

/// Of the materials that bodies are of; those whose parameters vary: at their reference values.
std::optional<Real> smallest_softened_strain(const Model& model)
{
  Real smallest = std::numeric_limits<Real>::infinity();
  for (const SoilMaterial& material : model.materials)
    if (row_of(material, Role::plastic_strain) >= 0) smallest = std::min(smallest, material.law->softened_strain());
  return std::isfinite(smallest) ? std::optional(smallest) : std::nullopt;
}

}  // namespace

StepsMade make_steps(const Model& model, State& state, Workspace& work, const StepPolicy& policy)
{
  for (std::int64_t n = 0; n < policy.most_steps; ++n) {
    const bool may_stop = policy.stop != nullptr && n >= policy.least_steps;
    if (may_stop && policy.stop->load(std::memory_order_relaxed)) return {.end = LoopEnd::stopped};
    if (std::string fault = policy.clock_stands ? "" : place_due_loads(model, state); !fault.empty())
      return {.end = LoopEnd::fault, .fault = std::move(fault)};
    if (!policy.clock_stands && remove_due_bodies(model, state)) work.fit(model, state);
    if (!policy.clock_stands) look_at_soil(model, state);
    make_step(model, state, work);
    if (policy.clock_stands) state.step = 0, state.time = 0.0;
    if (std::string fault = find_fault(model, state, work, state.largest_v_999); !fault.empty())
      return {.end = LoopEnd::fault, .fault = std::move(fault)};
    if (policy.after_step && !policy.after_step()) return {.end = LoopEnd::enough};
  }
  return {.end = LoopEnd::all_steps};
}

bool has_started(const State& state) { return state.step > 0 || !state.rows_reported.empty(); }

Outcome run(const Model& model, State& state, Workspace& work, std::span<Observer* const> observers,
    const std::atomic<bool>& stop, std::int64_t until)
{
  Loop loop{.model = model, .state = state, .reporter = Reporter(model, state, work, observers)};
  if (!has_started(state)) {
    const Search search = start_run(model, state, stop, loop);
    if (!search.fault.empty()) {
      loop.report_due(false);  // the state as the search left it, to look at
      if (search.slides_as_drawn) throw SlidesAsDrawn(loop.reporter.keep_evidence(search.fault));
      loop.reporter.stop_run(search.fault);
    }
    if (!search.reached) {
      loop.report_checkpoint();
      return Outcome::interrupted;
    }
    loop.report_due(false);
  }
  if (state.rows_reported.empty()) loop.report_due(true);  // it begins with the state of another run
  watch_speed(model.stage.rest.steps > 0 || model.flood_level.is_known(), work);
  const auto report_what_is_due = [&] {
    watch_rest(model, work, state);
    const bool ends = ends_now(model, work, state);
    loop.report_due(ends);
    loop.report_progress(ends && model.stage.is_last());
    return !ends;
  };
  const StepsMade made = make_steps(model, state, work,
      {.most_steps = until - state.step,
          .stop = &stop,
          .least_steps = state.step == 0 ? 1 : 0,  // a checkpoint of step 0 is that of a search that goes on
          .after_step = report_what_is_due});
  if (made.end == LoopEnd::fault) loop.reporter.stop_run(made.fault);
  if (made.end == LoopEnd::stopped) loop.report_checkpoint();
  state.wall_s = loop.wall_before + seconds_since(loop.start);
  return made.end == LoopEnd::stopped ? Outcome::interrupted : Outcome::finished;
}

namespace {

std::vector<StrengthWater> strength_water_of(const Case& description)
{
  std::vector<StrengthWater> strengths;
  for (const MaterialCase& material : description.materials)
    for (const ParameterField& field : material.fields) {
      const FieldNeeds& needs = field.needs;
      if (needs.stress_water.empty()) continue;
      strengths.push_back({material.name, std::string(material.type()->parameters[field.parameter].name),
          needs.stress_water, needs.daily_water.empty() ? std::nullopt : std::optional(needs.daily_water)});
    }
  return strengths;
}

}  // namespace

Summary summarise(const Model& model, const State& state)
{
  Summary s;
  s.scheme = model.description.scheme;
  s.method = model.method;
  s.at_strength = model.description.at_strength;
  s.n_points = state.points.n_points();
  s.n_cells = model.mesh->n_cells();
  s.n_steps = state.step;
  s.dt = model.dt;
  s.wall_s = state.wall_s, s.search_s = state.search_s;
  s.search_steps = state.equilibrium_steps;
  const double of_steps = s.wall_s - s.search_s;
  s.point_steps_per_s =
      of_steps > 0.0 ? static_cast<double>(s.n_points) * static_cast<double>(s.n_steps) / of_steps : 0.0;
  s.threads = model.threads;
  s.instructions = state.instructions.empty() ? std::string(instructions()) : state.instructions;
  s.processor = processor_name();
  s.softened_strain = smallest_softened_strain(model);
  const WorkTotals& w = state.work;
  const Real exchanged = energy_exchanged(state);
  // Velocities are those of half a step before the places, so half of the last step's work is not yet in the kinetic
  // energy (docs/methods.md, section 5).
  const Real half_step = 0.5 * w.last_step;
  const Real numerical =
      kinetic_and_stored_energy(model, state) + half_step + w.plastic + w.slip - state.start_energy - w.given();
  s.unexplained_energy = unexplained_share(state);
  s.energy_balance_error = exchanged > 0.0 ? std::abs(numerical) / exchanged : 0.0;
  s.clamped_points = state.clamped;
  for (std::size_t k = 0; k < state.stages_done.size(); ++k) {
    const bool has_name = k < model.description.stages.size();
    if (has_name || model.stage.rest.steps > 0)
      s.stages.push_back({has_name ? model.description.stages[k].name : "", state.stages_done[k]});
  }
  if (const auto k = state.stages_done.size(); k < model.description.stages.size() && k == model.stage.number) {
    StageSummary& runs = s.stages.emplace_back();
    runs.name = model.description.stages[k].name;
    runs.record.start = model.time_of(state.stage_start);
    runs.record.steps = state.step - state.stage_start;
  }
  s.strength_water = strength_water_of(model.description);
  s.v_999 = state.largest_v_999;
  for (const ActiveFollower& active : state.followers) active.follower->summarise(model, state, s);
  s.findings = findings_against(model, s);
  return s;
}

}  // namespace terp
