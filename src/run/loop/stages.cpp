// enter_next_stage: what was dug away leaves; then stored stress, laws, parameters, carried pressures and bodies
// change. The difference of energy counts as energy of the start. Loads find their ground after that. The counters of
// the stage move last; only then displacement may begin anew.

#include "run/loop/stages.hpp"

#include "math/errors.hpp"
#include "mpm/features/rest.hpp"
#include "model/water/carried_water.hpp"
#include "mpm/features/water.hpp"
#include "mpm/points/moved.hpp"
#include "model/parts/change_soil.hpp"
#include "mpm/step/stored_energy.hpp"
#include "mpm/step/workspace.hpp"
#include "model/ground/ground_section.hpp"
#include "run/rest/shear_wave.hpp"
#include "model/loads/loads.hpp"
#include "run/loop/placed_bodies.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/parts/setup.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// Enters where the soil is, the look-th time, and compares with where it was `rest.steps` before.
bool rests_by_mean(const RestRule& rest, std::int64_t look, Ground ground, State& state)
{
  RestMarks& marks = state.rest_marks;
  const std::size_t n = state.x_initial.size();
  marks.places.resize(static_cast<std::size_t>(RestMarks::n) * n);
  const std::span<Real> mark(marks.places.data() + static_cast<std::size_t>(look % RestMarks::n) * n, n);
  const bool rests = look >= RestMarks::n && find_moved(state.points, mark, rest.distance, ground).volume < rest.volume;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (std::size_t d = 0; d < 2; ++d) mark[2 * id + d] = block.row(Rows::x + static_cast<int>(d))[lane];
  });
  return rests;
}

/// The rule of the stage. Where the verdict ends it, its time is that in which the soil of its first step swings once.
RestRule rule_of(const Model& model, State& state)
{
  RestRule rest = model.stage.rest;
  if (!rest.with_verdict) return rest;
  std::int64_t& swing = state.rest_marks.swing;
  if (swing == 0) {
    const Real looks = std::ceil(4.0 * time_to_cross(model, state) / (RestMarks::n * model.dt) * (1.0 - 1e-12));
    swing = std::max(rest.steps, RestMarks::n * static_cast<std::int64_t>(looks));
  }
  rest.steps = swing;
  rest.distance = rest.speed * static_cast<Real>(swing) * model.dt;
  return rest;
}

/// After each step in which nothing changes any more: whether hardly any soil went far, or the verdict is known.
bool rests_or_is_known(const RestRule& rest, const Model& model, State& state)
{
  const std::int64_t every = rest.steps / RestMarks::n, step = state.rest_marks.steps++, look = step / every;
  if (step % every != 0) return false;
  if (!rest.with_verdict) return rests_by_mean(rest, look, {}, state);
  bool known = rests_by_mean(rest, look, ground_of(model), state);
  state.rest_marks.rests = known;
  for (const ActiveFollower& active : state.followers) known |= active.follower->is_answered(model, state, look == 0);
  const auto waits = [&](const ActiveFollower& active) { return active.follower->waits(state); };
  return known && std::ranges::none_of(state.followers, waits);
}

/// Displacement and strain are counted from now on.
void reset_displacement(State& state)
{
  state.moved_before.resize(static_cast<std::size_t>(state.n_ids()), 0.0);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    state.moved_before[id] = farthest_way(block, lane, state.x_initial, state.moved_before);
    for (int d = 0; d < 2; ++d) state.x_initial[2 * id + d] = block.row(Rows::x + d)[lane];
    for (int k = 0; k < n_sym<2>; ++k) block.row(Rows::strain + k)[lane] = 0.0;
  });
}

/// Places loads that begin with the stage on the ground as it is now. Places loads anew that stand on soil which the
/// stage digs away.
void place_new_loads(const Model& before, const Model& model, State& state)
{
  const std::span<const Load> loads = loads_of(model);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Load& load = loads[k];
    const bool is_new = load.is_permanent() && !(loads_of(before)[k].pressure > 0.0) && load.pressure > 0.0;
    if (!is_new && (!(load.pressure > 0.0) || !stands_on_what_goes(model, load, state))) continue;
    if (const std::string why = place_load(model, load, state); !why.empty())
      throw RunError(fmt::format("t = {:.4f} s: there is no ground under the load `{}`, which the stage `{}` {}\n  {}",
          state.time, load.name, model.stage.name, is_new ? "puts on" : "digs the ground away from", why));
  }
}

/// What does not follow from the case.
void keep_rest_of(const Model& before, Model& model)
{
  model.followers = before.followers;
  model.history_ids = before.history_ids;
  model.bodies = before.bodies;
}

}  // namespace

std::int64_t last_step_of_stage(const Model& model, const State& state)
{
  return state.stage_start + model.stage.steps;
}

std::int64_t last_step_of_run(const Model& model, const State& state)
{
  return last_step_of_stage(model, state) + model.stage.steps_after;
}

bool has_ended(const Model& model, const State& state)
{
  const RestRule& rest = model.stage.rest;
  if (!model.stage.name.empty()) return std::ssize(state.stages_done) > state.stage;
  return state.step >= last_step_of_stage(model, state) || (rest.steps > 0 && state.quiet_steps >= rest.steps);
}

bool is_decided_later(const Case& c, std::size_t number)
{
  const StageCase& stage = c.stages[number];
  if (stage.changed && stage.changed->at_strength < 1.0) return true;
  if (number + 1 == c.stages.size()) return false;
  std::string water;
  for (std::size_t k = 0; k <= number; ++k)
    if (!c.stages[k].water.empty()) water = c.stages[k].water;
  const StageCase& next = c.stages[number + 1];
  return (next.water.empty() || next.water == water) && next.changes.empty() && next.place.empty() &&
         next.remove.empty();
}

bool holds_soil(const Case& c, std::size_t number)
{
  if (number >= c.stages.size()) return false;
  const Real held = c.stages[number].changed->at_strength;
  return held < 1.0 && std::any_of(c.stages.begin() + static_cast<std::ptrdiff_t>(number) + 1, c.stages.end(),
                           [&](const StageCase& later) { return later.changed->at_strength > held; });
}

void watch_rest(const Model& model, const Workspace& work, State& state)
{
  const RestRule rest = rule_of(model, state);
  if (rest.steps == 0) return;
  const Real changes_until = std::max(rest.last_change, model.ramp.start + model.ramp.duration);
  const bool may_rest = state.time > changes_until;
  if (rest.by_mean)
    state.quiet_steps = may_rest && rests_or_is_known(rest, model, state) ? rest.steps : 0;
  else
    state.quiet_steps = may_rest && fastest_node(work) < rest.speed ? state.quiet_steps + 1 : 0;
}

bool ends_now(const Model& model, const Workspace& work, State& state)
{
  const RestRule rest = rule_of(model, state);
  const bool early = rest.steps > 0 && state.quiet_steps == rest.steps;
  if (!early && state.step != last_step_of_stage(model, state)) return false;
  if (model.stage.name.empty() && rest.steps == 0) return true;
  const bool known = early && rest.with_verdict, rests = early && (!known || state.rest_marks.rests);
  const bool speed_counts = rest.steps > 0 && (!known || rests);  // the verdict does not wait for soil of a flood
  state.stages_done.push_back({.start = model.time_of(state.stage_start),
      .end = state.time,
      .steps = state.step - state.stage_start,
      .at_rest = rests,
      .fastest = speed_counts ? fastest_node(work) : std::numeric_limits<Real>::quiet_NaN(),
      .known_for = known ? static_cast<Real>(rest.steps) * model.dt : 0.0});
  return true;
}

Model model_for(Model model, const State& state)
{
  const auto number = static_cast<std::size_t>(state.stage);
  if (number != model.stage.number) {
    Model other = build_stage(model, number);
    keep_rest_of(model, other);
    model = std::move(other);
  }
  model.first_step = state.first_step;
  model.first_time = state.first_time;
  model.ramp.start = model.time_of(state.stage_start);
  return model;
}

void enter_next_stage(Model& model, State& state, Workspace& work)
{
  Model next = build_stage(model, model.stage.number + 1);
  keep_rest_of(model, next);
  TERP_ASSERT(next.dt == model.dt);  // or the clock would jump
  next.ramp.start = model.time_of(state.step);
  remove_held_bodies(model, state);
  const Real before = kinetic_and_stored_energy(model, state);
  const auto is_of_material = [](const auto& change) {
    return change.first.starts_with("material") || change.first == "at_strength";
  };
  const bool sets_parameters = std::ranges::any_of(model.description.stages[next.stage.number].changes, is_of_material);
  // Points of a file are read again for them: not in a stage that changes loads or water alone.
  const bool needs_seeds = sets_parameters || stores_other_stress(model, next) || next.with.bodies;
  const Seeds seeds = needs_seeds ? seeds_of(make_points(next)) : Seeds{};
  const std::vector<Real> carried = carried_pressures(model, state);
  if (stores_other_stress(model, next)) change_stored_stress(model, next, seeds, state);
  if (!have_same_materials(model, next)) change_materials(next, seeds, carried, state);
  if (sets_parameters) set_point_parameters(next, seeds, state);
  keep_carried_pressures(next, carried, state);
  change_bodies(next, seeds, state);
  state.start_energy += kinetic_and_stored_energy(next, state) - before;
  place_new_loads(model, next, state);
  ++state.stage;
  state.stage_start = state.step;
  state.quiet_steps = 0;
  state.rest_marks = {};
  model = model_for(std::move(next), state);
  if (model.description.stages[model.stage.number].reset_displacement) {
    for (const ActiveFollower& active : state.followers) active.follower->count_displacement_anew(model, state);
    reset_displacement(state);
  }
  look_anew(model, state);
  forget_water(work);
  work.fit(model, state);
}

}  // namespace terp
