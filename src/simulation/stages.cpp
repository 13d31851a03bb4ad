#include "simulation/stages.hpp"

#include "base/errors.hpp"
#include "simulation/ledger.hpp"
#include "simulation/loads.hpp"
#include "simulation/nodal_water.hpp"
#include "simulation/point_parameters.hpp"
#include "simulation/setup.hpp"
#include "simulation/setup_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

using Rows = PointRows<2>;

/// The time of the last change that the case orders beyond that of stages: loads that come or go [s].
Real last_change_of_loads(const Case& c)
{
  Real last = 0.0;
  for (const LoadCase& load : c.loads)
    for (const Real time : {load.start, load.end})
      if (std::isfinite(time)) last = std::max(last, time + load.ramp);
  return last;
}

/// The step nearest to the planned end of a stage, if all before it take their whole time.
std::int64_t planned_end(const Case& whole, std::size_t number, Real dt)
{
  Real time = 0.0;
  for (std::size_t k = 0; k <= number; ++k) time += whole.stages[k].longest();
  return std::llround(time / dt);
}

StageWater water_of(const Case& whole, std::size_t number)
{
  StageWater water;
  for (std::size_t k = 0; k <= number; ++k) {
    water.from = water.to;
    if (whole.stages[k].water.empty()) continue;
    water.given = true;
    const auto& others = whole.water.situations;
    const auto found = std::ranges::find(others, whole.stages[k].water, &WaterSituation::name);
    water.to = found == others.end() ? 0 : static_cast<std::size_t>(found - others.begin()) + 1;
  }
  return water;
}

/// Every stage must have a step of its own.
void check_lengths(const Case& whole, Real dt)
{
  for (std::size_t k = 0; k < whole.stages.size(); ++k) {
    const StageCase& c = whole.stages[k];
    if (planned_end(whole, k, dt) > (k == 0 ? 0 : planned_end(whole, k - 1, dt))) continue;
    throw InputError(Problem{fmt::format("stage[{}].{}", k, c.until == Until::end ? "duration" : "at_most"),
        "the stage is shorter than a time step",
        fmt::format("Got {:.3g} s; the time step is {:.3g} s.", c.longest(), dt), "stage"});
  }
}

/// Body and place of each point as it is seeded, by id. Displacement may be counted from later places.
struct Seeds {
  std::vector<Index> bodies;
  std::vector<Real> places;  ///< [m], shape [n, 2]
};

Seeds seeds_of(const Model& model)
{
  Seeds seeds;
  for (const auto& batch : make_points(model))
    for (const NewPoint& p : batch) {
      seeds.bodies.push_back(p.body);
      seeds.places.insert(seeds.places.end(), p.x.begin(), p.x.end());
    }
  return seeds;
}

/// Gives a point of another material the mass of that material and the rows that only its law has.
void change_row_values(const Model& model, Index from, Index to, std::vector<Real>& values)
{
  values[Rows::mass] *= model.materials[to].density / model.materials[from].density;
  for (const RowInfo& row : model.rows.added())
    if (row.is_of(to) && !row.is_of(from)) std::fill_n(values.begin() + row.first, row.n, row.initial);
}

/// A point on its way to a block of another material.
struct MovedPoint {
  BlockKey key;
  std::vector<Real> values;
};

/// Material in the stage of a model of a point that was of another one. What was below the water line stays so.
Index material_in_stage(const Model& model, Index body, Index from)
{
  const BodyCase& of = model.description.bodies[body];
  const MaterialCase& now = model.description.materials[from];
  const bool stays = !of.points_file.empty() || now.called() == of.material;
  return stays ? from : material_number(model, of.material, now.zone);
}

bool stores_other_stress(const Model& before, const Model& model)
{
  const auto kind = [](const Model& of) {
    std::vector<bool> effective;
    for (const SoilMaterial& material : of.materials) effective.push_back(material.stores_effective);
    return effective;
  };
  const auto same_material = [](const BodyCase& a, const BodyCase& b) { return a.material == b.material; };
  return kind(before) != kind(model) ||
         !std::ranges::equal(before.description.bodies, model.description.bodies, same_material);
}

/// Soil that stored effective stress and stores total stress from now on, or the other way round: the stress of both
/// differs by the pore pressure, with all that the soil had in excess.
void change_stored_stress(const Model& before, const Model& model, State& state)
{
  const std::vector<Index> body = seeds_of(model).bodies;
  const PorePressure pore = before.water ? water_at(before, state.time) : PorePressure();
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& from = before.materials[block.material];
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Index to = material_in_stage(model, body[id], block.material);
    if (from.stores_effective == model.materials[to].stores_effective) return;
    Real pressure = before.water ? pore_pressure_at(before, pore, block, lane) : 0.0;
    if (from.excess_row >= 0) {
      pressure += block.row(from.excess_row)[lane];
      block.row(from.excess_row)[lane] = 0.0;
    }
    for (int k = 0; k < 3; ++k) block.row(Rows::sigma + k)[lane] += from.stores_effective ? -pressure : pressure;
  });
}

/// Takes the points out of their blocks whose body is of another material than they are.
std::vector<MovedPoint> take_changed_points(const Model& model, const std::vector<Index>& body, State& state)
{
  std::vector<MovedPoint> moved;
  for (const Index cell : state.points.occupied())
    for (Index b = state.points.first_block(cell); b >= 0; b = state.points.block(b).next)
      for (Index lane = state.points.block(b).n; lane-- > 0;) {
        const PointBlock<2>& block = state.points.block(b);
        const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
        const Index from = block.material, to = material_in_stage(model, body[id], from);
        if (to == from) continue;
        MovedPoint& point =
            moved.emplace_back(MovedPoint{block, std::vector<Real>(static_cast<std::size_t>(state.points.n_rows()))});
        state.points.take(b, lane, point.values);
        change_row_values(model, from, to, point.values);
        point.key.material = to;
      }
  return moved;
}

/// Displacement and strain are counted from now on.
void reset_displacement(State& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (int d = 0; d < 2; ++d) state.x_initial[2 * id + d] = block.row(Rows::x + d)[lane];
    for (int k = 0; k < n_sym<2>; ++k) block.row(Rows::strain + k)[lane] = 0.0;
  });
}

/// Loads of which there was nothing take their place on the ground as it is now.
void place_new_loads(const Model& before, const Model& model, State& state)
{
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    const Load& load = model.loads[k];
    if (!load.is_permanent() || before.loads[k].pressure > 0.0 || !(load.pressure > 0.0)) continue;
    if (const std::string why = place_load(load, state); !why.empty())
      throw RunError(
          fmt::format("t = {:.4f} s: there is no ground under the load `{}`, which the stage `{}` puts on\n  {}",
              state.time, load.name, model.stage.name, why));
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

const Case& case_of_stage(const Case& description, std::size_t number)
{
  return description.stages.empty() ? description : *description.stages[number].changed;
}

std::size_t water_of_last_stage(const Case& whole)
{
  return whole.stages.empty() ? 0 : water_of(whole, whole.stages.size() - 1).to;
}

std::string stage_file(std::size_t number, const std::string& name)
{
  return fmt::format("stage_{:02}_{}.h5", number + 1, name);
}

void set_stage(const Case& whole, std::size_t number, Model& model)
{
  Stage& stage = model.stage;
  stage.steps = model.n_steps;
  Until until = whole.time.until;
  model.gravity_before = model.gravity;
  if (!whole.stages.empty()) {
    const StageCase& c = whole.stages[number];
    const std::int64_t start = number == 0 ? 0 : planned_end(whole, number - 1, model.dt);
    stage.name = c.name;
    stage.number = number;
    stage.n_all = whole.stages.size();
    stage.steps = planned_end(whole, number, model.dt) - start;
    stage.steps_after = model.n_steps - start - stage.steps;
    until = c.until;
    check_lengths(whole, model.dt);
    model.ramp.duration = c.ramp;
    stage.water = water_of(whole, number);
    if (c.ramp > 0.0) {
      const Case& before = number == 0 ? whole : case_of_stage(whole, number - 1);
      model.gravity_before = before.forces.gravity;
      for (std::size_t k = 0; k < model.loads.size(); ++k) model.loads[k].before = before.loads[k].pressure;
    }
  }
  if (until == Until::at_rest) {
    const Real n = std::ceil(whole.time.rest_time / model.dt * (1.0 - 1e-12));
    stage.rest = {.speed = whole.time.rest_speed,
        .steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(n)),
        .last_change = last_change_of_loads(model.description)};
  }
}

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

void watch_rest(const Model& model, const Workspace& work, State& state)
{
  const RestRule& rest = model.stage.rest;
  if (rest.steps == 0) return;
  const Real changes_until = std::max(rest.last_change, model.ramp.start + model.ramp.duration);
  const bool quiet = work.fastest_node < rest.speed && state.time > changes_until;
  state.quiet_steps = quiet ? state.quiet_steps + 1 : 0;
}

bool ends_now(const Model& model, const Workspace& work, State& state)
{
  const RestRule& rest = model.stage.rest;
  const bool at_rest = rest.steps > 0 && state.quiet_steps == rest.steps;
  if (!at_rest && state.step != last_step_of_stage(model, state)) return false;
  if (model.stage.name.empty() && rest.steps == 0) return true;
  state.stages_done.push_back({.start = model.time_of(state.stage_start),
      .end = state.time,
      .steps = state.step - state.stage_start,
      .at_rest = at_rest,
      .fastest = rest.steps > 0 ? work.fastest_node : std::numeric_limits<Real>::quiet_NaN()});
  return true;
}

void change_materials(const Model& model, State& state)
{
  const Seeds seeds = seeds_of(model);
  std::vector<MovedPoint> moved = take_changed_points(model, seeds.bodies, state);
  for (auto point = moved.rbegin(); point != moved.rend(); ++point) state.points.add(point->key, point->values);
  state.points.update_occupied();
  const auto varies = [&](const MovedPoint& point) { return model.materials[point.key.material].varies(); };
  if (std::ranges::any_of(moved, varies)) set_point_parameters(model, seeds.places, state);
}

Model model_for(Model model, const State& state)
{
  const auto number = static_cast<std::size_t>(state.stage);
  if (number != model.stage.number) {
    Model other = build_stage(*model.whole, model.mesh, model.threads, number);
    keep_rest_of(model, other);
    model = std::move(other);
  }
  model.first_step = state.first_step;
  model.first_time = state.first_time;
  model.ramp.start = model.time_of(state.stage_start);
  return model;
}

void begin_from(Model& model, const std::string& stage_that_ended, State& state)
{
  const auto& stages = model.description.stages;
  const auto found = std::ranges::find(stages, stage_that_ended, &StageCase::name);
  const bool goes_on = !stage_that_ended.empty() && found != stages.end();
  const StageRecord last = state.stages_done.empty() ? StageRecord{} : state.stages_done.back();
  state.stage = goes_on ? found - stages.begin() : 0;
  state.stages_done.resize(goes_on ? static_cast<std::size_t>(state.stage) + 1 : 0, last);
  if (goes_on) state.stages_done.back() = last;
  state.stage_start = state.step;
  state.quiet_steps = 0;
  const Real round_off = 1e-9 * model.dt * static_cast<Real>(std::max<std::int64_t>(state.step, 1));
  if (std::abs(model.time_of(state.step) - state.time) > round_off) {
    state.first_step = state.step;
    state.first_time = state.time;
  }
  state.rows_reported.clear();
  state.frames_reported = 0;
  const Real before = kinetic_and_elastic_energy(model, state);
  model = model_for(std::move(model), state);
  change_stored_stress(model, model, state);
  change_materials(model, state);
  set_point_parameters(model, seeds_of(model).places, state);  // fields of this case, not of the other run
  state.start_energy += kinetic_and_elastic_energy(model, state) - before;
}

void enter_next_stage(Model& model, State& state, Workspace& work)
{
  Model next = build_stage(*model.whole, model.mesh, model.threads, model.stage.number + 1);
  keep_rest_of(model, next);
  TERP_ASSERT(next.dt == model.dt);  // or the clock would jump
  const Real before = kinetic_and_elastic_energy(model, state);
  if (stores_other_stress(model, next)) change_stored_stress(model, next, state);
  const auto same_material = [](const BodyCase& a, const BodyCase& b) { return a.material == b.material; };
  if (!std::ranges::equal(model.description.bodies, next.description.bodies, same_material))
    change_materials(next, state);
  const auto is_of_material = [](const auto& change) {
    return change.first.starts_with("material") || change.first == "at_strength";
  };
  if (std::ranges::any_of(model.description.stages[next.stage.number].changes, is_of_material))
    set_point_parameters(next, seeds_of(next).places, state);
  state.start_energy += kinetic_and_elastic_energy(next, state) - before;
  place_new_loads(model, next, state);
  ++state.stage;
  state.stage_start = state.step;
  state.quiet_steps = 0;
  model = model_for(std::move(next), state);
  if (model.description.stages[model.stage.number].reset_displacement) {
    for (const ActiveFollower& active : state.followers) active.follower->count_displacement_anew(model, state);
    reset_displacement(state);
  }
  work.damping_local = model.damping.local;
  work.water_share = std::numeric_limits<Real>::quiet_NaN();
  work.fit(model, state);
}

}  // namespace terp
