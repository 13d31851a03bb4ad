// The end of a stage is rounded to a step from the sum of all durations until then, so that rounding does not add up.

#include "model/parts/stage_case.hpp"

#include "math/errors.hpp"
#include "model/loads/loads.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// The time of the last change that the case orders beyond that of stages: loads that come or go, water on its way [s].
/// Infinite where a formula of the water speaks of the time.
Real last_change(const Case& c, const StageWater& water)
{
  Real last = 0.0;
  for (const LoadCase& load : c.loads)
    for (const Real time : {load.start, load.end})
      if (std::isfinite(time)) last = std::max(last, time + load.ramp);
  if (!c.water.is_given()) return last;
  std::vector<std::size_t> situations{water.from, water.to};
  if (!water.given)
    for (const WaterKnot& knot : knots_of(c.water)) {
      situations.push_back(knot.situation);
      last = std::max(last, knot.time);
    }
  const auto changes = [&](std::size_t number) { return situation_of(c.water, number).formula_changes; };
  return std::ranges::any_of(situations, changes) ? std::numeric_limits<Real>::infinity() : last;
}

/// The step nearest to the planned end of a stage, if all before it take their whole time.
std::int64_t planned_end(const Case& whole, std::size_t number, Real dt)
{
  Real time = 0.0;
  for (std::size_t k = 0; k <= number; ++k) time += whole.stages[k].longest();
  return std::llround(time / dt);
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

/// [m^2]
Real mean_cell(const Mesh<2>& mesh)
{
  Real all = 0.0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) all += mesh.geometry(cell).volume;
  return all / static_cast<Real>(mesh.n_cells());
}

}  // namespace

const Case& case_of_stage(const Case& description, std::size_t number)
{
  return description.stages.empty() ? description : *description.stages[number].changed;
}

StageWater water_of_stage(const Case& whole, std::size_t number)
{
  StageWater water;
  for (std::size_t k = 0; k < std::min(number + 1, whole.stages.size()); ++k) {
    water.from = water.to;
    if (whole.stages[k].water.empty()) continue;
    water.given = true;
    water.to = situation_number(whole.water, whole.stages[k].water);
  }
  return water;
}

void set_ramp(const Case& whole, std::size_t number, Model& model)
{
  const Case& now = case_of_stage(whole, number);
  const bool ramps = !whole.stages.empty() && whole.stages[number].ramp > 0.0;
  const Case& before = !ramps ? now : number == 0 ? whole : case_of_stage(whole, number - 1);
  model.ramp.duration = ramps ? whole.stages[number].ramp : 0.0;
  model.gravity = now.forces.gravity;
  model.gravity_before = before.forces.gravity;
  model.at_strength_before = number == 0 ? 1.0 : before.at_strength / now.at_strength;
  LoadsModel loads{make_loads(now, before), now.forces.body.at};
  if (!loads.all.empty() || loads.body_force) model.with.loads = std::make_shared<const LoadsModel>(std::move(loads));
  model.stage.water = water_of_stage(whole, number);
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
  }
  if (until != Until::end) {
    const bool with_verdict = until == Until::verdict, by_mean = with_verdict || whole.time.rest_by == RestBy::mean;
    const std::int64_t looks = by_mean ? RestMarks::n : 1;
    const Real n = std::ceil(whole.time.rest_time / (looks * model.dt) * (1.0 - 1e-12));
    stage.rest = {.speed = whole.time.rest_speed,
        .steps = looks * std::max<std::int64_t>(1, static_cast<std::int64_t>(n)),
        .by_mean = by_mean,
        .with_verdict = with_verdict,
        .last_change = last_change(model.description, stage.water)};
    stage.rest.distance = stage.rest.speed * stage.rest.steps * model.dt;
    stage.rest.volume = mean_cell(*model.mesh);
  }
}

}  // namespace terp
