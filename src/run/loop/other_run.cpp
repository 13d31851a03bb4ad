// Soil changes as from stage to stage, in the order of enter_next_stage (stages.cpp): change both together. Between,
// the state goes through an image with the rows of this run: it is refused where laws or method keep other rows.
// Followers begin with what they find, and the change of energy counts as energy of the start.

#include "run/loop/other_run.hpp"

#include "math/errors.hpp"
#include "model/parts/change_soil.hpp"
#include "run/report/ledger.hpp"
#include "model/loads/loads.hpp"
#include "run/loop/placed_bodies.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/parts/setup.hpp"
#include "model/bodies/setup_points.hpp"
#include "run/loop/stages.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/state_image.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// The load of the other run that stands on the same stretch under the same name; nullptr: there is none.
const Load* same_load(const Model& before, const Load& load)
{
  const std::span<const Load> loads = loads_of(before);
  const auto found = std::ranges::find_if(loads,
      [&](const Load& other) { return other.name == load.name && other.from == load.from && other.to == load.to; });
  return found == loads.end() ? nullptr : &*found;
}

/// The step before which a load has taken its place, of a model at its state.
bool was_placed(const Model& model, const State& state, const Load& load)
{
  if (load.is_permanent()) return load.pressure > 0.0;
  return model.first_step + load.first_step(model.dt, model.first_time) < state.step;
}

std::string row_name(const Model& model, int first)
{
  const auto row = std::ranges::find(model.rows.entries(), first, &RowInfo::first);
  TERP_ASSERT(row != model.rows.entries().end());
  return "points/" + row->name;
}

/// What a run may give its points anew. The state of the laws, and what the method keeps, must be that of the other
/// run.
bool may_differ(const RowInfo& row)
{
  return row.owner == "load" || row.owner == "water" || row.owner == "stage" || row.owner == "slip" ||
         row.name.starts_with("parameter_");
}

/// The state with the rows of this run. Loads keep their points; rows that the other run did not have begin with their
/// initial values.
StateImage image_for(const Model& before, const Model& model, const State& state)
{
  StateImage image = make_image(state);
  std::vector<NamedArray> loads;
  for (const Load& load : loads_of(model))
    if (const Load* other = same_load(before, load)) {
      const auto found = std::ranges::find(image.arrays, row_name(before, other->row), &NamedArray::name);
      loads.push_back(*found);
      loads.back().name = row_name(model, load.row);
    }
  const auto has_row = [&](const RowInfo& row) {
    return std::ranges::find(model.rows.entries(), row.name, &RowInfo::name) != model.rows.entries().end();
  };
  const auto is_gone = [&](const RowInfo& row) { return row.owner == "load" || (may_differ(row) && !has_row(row)); };
  for (const RowInfo& row : before.rows.added())
    if (is_gone(row)) std::erase_if(image.arrays, [&](const NamedArray& a) { return a.name == "points/" + row.name; });
  image.arrays.insert(image.arrays.end(), loads.begin(), loads.end());
  const std::int64_t n = state.points.n_points();
  for (const RowInfo& row : model.rows.added()) {
    const std::string name = "points/" + row.name;
    if (!row.saved || !may_differ(row) || ArrayReader(image.arrays).has(name)) continue;
    image.arrays.push_back({name, {n}, std::vector<Real>(static_cast<std::size_t>(n), row.initial), 0});
  }
  const std::size_t n_forces = 2 * model.mesh->nodes.size();
  if (model.damping.averaging_time > 0.0 && !state.with.mean_force)
    image.arrays.push_back({"mean_force", {static_cast<std::int64_t>(n_forces)}, std::vector<Real>(n_forces, 0.0), 0});
  return image;
}

/// Points have their numbers in the order in which stages place their bodies.
Seeds seeds_of_both(const Model& before, const Model& model)
{
  Seeds seeds = seeds_of(make_points(model));
  if (seeds_of(make_points(before)) == seeds) return seeds;
  throw InputError(Problem{"stage", "the points of the other run have other numbers",
      "Stages place other bodies there, or in another order. Place the same bodies in the same order as its case.toml.",
      "stage.place", true});
}

/// Loads that stand on the soil in this run and did not in the other one, or elsewhere, take their place.
void place_loads(const Model& before, const State& at_end, const Model& model, State& state)
{
  const std::span<const Load> loads = loads_of(model);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Load& load = loads[k];
    const Load* other = same_load(before, load);
    const bool stays = other != nullptr && was_placed(before, at_end, *other);
    if (!was_placed(model, state, load) || (stays && !stands_on_what_goes(model, load, state))) continue;
    if (const std::string why = place_load(model, load, state); !why.empty())
      throw InputError(Problem{fmt::format("load[{}].from", k),
          fmt::format("there is no ground under the load `{}` where the run begins", load.name), why, "load", false,
          {fmt::format("load[{}].to", k)}});
  }
}

/// Records of the stages of this case that are done: those of the other run by their names. Others took no time.
std::vector<StageRecord> records_of(const Model& before, const Model& model, std::size_t n_done, const State& state)
{
  std::vector<StageRecord> records;
  for (std::size_t k = 0; k < n_done; ++k) {
    const auto& names = before.description.stages;
    const auto found = std::ranges::find(names, model.description.stages[k].name, &StageCase::name);
    const auto number = static_cast<std::size_t>(found - names.begin());
    if (number < state.stages_done.size())
      records.push_back(state.stages_done[number]);
    else
      records.push_back({.start = state.time, .end = state.time, .fastest = NAN});
  }
  return records;
}

/// Number of stages of this case that are done.
std::size_t count_done(const Model& model, const std::string& stage_that_ended)
{
  const auto& stages = model.description.stages;
  const auto found = std::ranges::find(stages, stage_that_ended, &StageCase::name);
  if (stage_that_ended.empty() || found == stages.end()) return 0;
  if (found + 1 == stages.end())
    throw InputError(Problem{"stage",
        fmt::format("the run begins with the end of the stage `{}`, the last of this case", stage_that_ended),
        "No stage is left to solve. Add one after it, begin with the end of an earlier one, or give the stage of this "
        "case another name.",
        "stage", true});
  return static_cast<std::size_t>(found - stages.begin()) + 1;
}

}  // namespace

void begin_from(const Model& before, const std::string& stage_that_ended, Model& model, State& state)
{
  const Seeds seeds = seeds_of_both(before, model);
  const Real energy = kinetic_and_stored_energy(before, state);
  const std::size_t n_done = count_done(model, stage_that_ended);
  state.stages_done = records_of(before, model, n_done, state);
  state.stage = n_done == 0 ? 0 : static_cast<std::int64_t>(n_done) - 1;
  state.stage_start = state.step;
  state.quiet_steps = 0;
  state.rest_marks = {};
  state.rows_reported.clear();
  state.frames_reported = 0;
  model.first_step = state.first_step, model.first_time = state.first_time;
  const Real round_off = 1e-9 * model.dt * static_cast<Real>(std::max<std::int64_t>(state.step, 1));
  if (std::abs(model.time_of(state.step) - state.time) > round_off) {
    state.first_step = state.step;
    state.first_time = state.time;
  }
  model = model_for(std::move(model), state);
  const std::vector<Real> carried = carried_pressures(before, state);
  change_stored_stress(before, model, seeds, state);
  change_densities(before, model, state);
  State own = restore(model, image_for(before, model, state));
  change_materials(model, seeds, carried, own);
  set_point_parameters(model, seeds, own);
  keep_carried_pressures(model, carried, own);
  change_bodies(model, seeds, own);
  place_loads(before, state, model, own);
  const State first = build_state(model);
  for (ActiveFollower& active : own.followers) active.follower->begin_from(before, model, first);
  state = std::move(own);
  state.start_energy += kinetic_and_stored_energy(model, state) - energy;
  remove_held_bodies(model, state);
}

}  // namespace terp
