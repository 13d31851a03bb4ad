// Only the last stage may be driven beyond its end. The step of a time is rounded up, less round-off: a time that is a
// multiple of dt would else fall one step later. A saved state must agree with this case in its points and in the time
// of its step; what hangs on the stage and on the water is then made anew from it.

#include "run/loop/simulation.hpp"

#include "math/errors.hpp"
#include "model/parts/parts.hpp"
#include "mpm/features/water.hpp"
#include "mpm/step/stored_energy.hpp"
#include "mpm/step/workspace.hpp"
#include "run/report/frame.hpp"
#include "run/report/ledger.hpp"
#include "model/soils/point_parameters.hpp"
#include "run/loop/stages.hpp"
#include "run/report/state_image.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

Model with_followers(Model model, const FollowerTypes& followers)
{
  model.followers = followers;
  return model;
}

/// The rows that can be set: those that results show.
std::vector<std::string> names_to_set(const Model& model)
{
  std::vector<std::string> names;
  for (const RowInfo& row : model.rows.entries())
    if (row.shown) names.push_back(row.name);
  return names;
}

[[noreturn]] void refuse(const std::string& name, const std::string& what, const std::string& detail)
{
  throw InputError(Problem{name, what, detail, ""});
}

struct FieldPlace {
  int first_row = -1;  ///< -1: points of the material have no such variable
  int n_rows = 1, n_components = 1;
};

/// By material. Of a vector the third component is 0.
std::vector<FieldPlace> places_of(const Model& model, const std::string& name)
{
  std::vector<FieldPlace> places;
  for (const RowInfo& row : model.rows.entries())
    for (Index m = 0; row.shown && row.name == name && m < std::ssize(model.materials); ++m)
      places.push_back({row.is_of(m) ? row.first : -1, row.n, row.n == 2 ? 3 : row.n});
  if (places.empty())
    refuse(name, "there is no field of this name that can be set",
        fmt::format("These can be set: {}.", fmt::join(names_to_set(model), ", ")));
  return places;
}

template <class F>
void for_each_value(State& state, const std::vector<FieldPlace>& places, const std::vector<Real>& values, F&& f)
{
  for_each_point(state.points, [&](PointBlock<2> block, Index lane) {
    const FieldPlace& place = places[static_cast<std::size_t>(block.material)];
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    f(block, lane, place, values.data() + id * static_cast<std::size_t>(place.n_components));
  });
}

bool is_parameter(const SoilMaterial& material, int row)
{
  const std::span<const int> of_law = std::span(material.rows).subspan(static_cast<std::size_t>(material.n_state()));
  return std::ranges::find(of_law, row) != of_law.end();
}

void check_value(const Model& model, const State& state, const std::string& name, const PointBlock<2>& block,
    Index lane, const FieldPlace& place, const Real* value)
{
  const auto id = static_cast<std::int64_t>(block.row(Rows::id)[lane]);
  const SoilMaterial& material = model.materials[block.material];
  if (place.first_row < 0) {
    if (!std::isnan(*value))
      refuse(name, fmt::format("material point {} cannot take the value {}", id, *value),
          fmt::format("Its material `{}` ({}) has no `{}`: give NaN there, as the field itself does.", material.name,
              material.type->name, name));
    return;
  }
  for (int k = 0; k < place.n_components; ++k)
    if (!std::isfinite(value[k]))
      refuse(name, fmt::format("the value of material point {} is not a finite number", id),
          fmt::format("Component {} is {}.", k, value[k]));
  for (int k = place.n_rows; k < place.n_components; ++k)
    if (value[k] != 0.0)
      refuse(name, fmt::format("the value of material point {} points out of the plane", id),
          fmt::format("Component {} is {}, in plane strain it is 0.", k, value[k]));
  if (place.first_row == Rows::volume && !(*value > 0.0))
    refuse(
        name, fmt::format("the volume of material point {} is not positive", id), fmt::format("Got {} m^2.", *value));
  if (place.first_row == row_of(material, Role::plastic_strain) && *value < 0.0)
    refuse(
        name, fmt::format("the plastic strain of material point {} is below zero", id), fmt::format("Got {}.", *value));
  if (is_parameter(material, place.first_row))
    check_point_parameter(model, state, block, lane, place.first_row, *value);
}

}  // namespace

Simulation::Simulation(const Case& description, int threads, const FollowerTypes& followers)
    : model(with_followers(build_model(description, threads), followers)),
      state(build_state(model)),
      work_(std::make_unique<Workspace>(model, state)),
      work(*work_)
{
  model.threads = work.threads.count();
}

Simulation::Simulation(const Case& description, SharedMesh mesh, int threads, const FollowerTypes& followers)
    : model(with_followers(build_model(description, std::move(mesh), threads), followers)),
      state(build_state(model)),
      work_(std::make_unique<Workspace>(model, state)),
      work(*work_)
{
  model.threads = work.threads.count();
}

Simulation::Simulation(Model ready_model, State ready_state)
    : model(model_for(std::move(ready_model), ready_state)),
      state(std::move(ready_state)),
      work_(std::make_unique<Workspace>(model, state)),
      work(*work_)
{
  model.threads = work.threads.count();
}

Simulation::~Simulation() = default;

Outcome Simulation::start(const std::atomic<bool>& stop)
{
  return has_started(state) ? Outcome::finished : terp::run(model, state, work, observers, stop, 0);
}

Outcome Simulation::step(std::int64_t n, const std::atomic<bool>& stop)
{
  if (n < 0) throw InputError(Problem{"step", fmt::format("{} steps cannot be made", n), "Got a negative number.", ""});
  return advance(state.step + n, true, stop);
}

Outcome Simulation::advance_to(Real t, const std::atomic<bool>& stop)
{
  const Real step = step_at(t);
  if (!(step >= static_cast<Real>(state.step) && step < static_cast<Real>(most_steps)))
    throw InputError(Problem{"advance_to", fmt::format("the run cannot advance to t = {} s", t),
        fmt::format("It is at t = {:.4g} s and makes steps of {:.4g} s. `restore` goes back to a saved state.",
            state.time, model.dt),
        ""});
  return advance(static_cast<std::int64_t>(step), true, stop);
}

Outcome Simulation::run(const std::atomic<bool>& stop, Real until)
{
  const Real step = step_at(until);
  return advance(step < static_cast<Real>(most_steps) ? static_cast<std::int64_t>(step) : most_steps, false, stop);
}

Real Simulation::step_at(Real t) const
{
  return static_cast<Real>(model.first_step) + std::ceil((t - model.first_time) / model.dt * (1.0 - 1e-12));
}

Outcome Simulation::advance(std::int64_t until, bool beyond, const std::atomic<bool>& stop)
{
  for (;;) {
    const bool last = model.stage.is_last();
    if (has_ended(model, state)) {
      if (last ? !beyond : state.step >= until) return Outcome::finished;
      if (!last) {
        enter_next_stage(model, state, work);
        continue;
      }
    }
    const std::int64_t end = last && beyond ? until : std::min(until, last_step_of_stage(model, state));
    const Outcome outcome = terp::run(model, state, work, observers, stop, end);
    if (outcome == Outcome::interrupted || state.step >= until) return outcome;
  }
}

PointField Simulation::field(const std::string& name) const
{
  std::vector<std::string> names;
  if (auto field = make_field(model, state, name, names)) return std::move(*field);
  refuse(name, "there is no field of this name", fmt::format("Fields of this run: {}.", fmt::join(names, ", ")));
}

// All values are checked before the first is written: a refusal leaves the state as it was. In a run that has started,
// the energy that the new values bring is booked as energy of the start, and the followers are told. Else the balance
// would show it as a numerical error, and a strain set lower as one that fell.
void Simulation::set_field(const std::string& name, const std::vector<Real>& values)
{
  const std::vector<FieldPlace> places = places_of(model, name);
  const std::int64_t n = state.n_ids() * places.front().n_components;
  if (std::ssize(values) != n)
    refuse(name, fmt::format("{} values were given, {} are needed", values.size(), n),
        fmt::format("Its shape is [{}, {}], sorted by id.", state.n_ids(), places.front().n_components));
  for_each_value(
      state, places, values, [&](const PointBlock<2>& block, Index lane, const FieldPlace& place, const Real* value) {
        check_value(model, state, name, block, lane, place, value);
      });
  const Real before = kinetic_and_stored_energy(model, state);
  for_each_value(
      state, places, values, [&](const PointBlock<2>& block, Index lane, const FieldPlace& place, const Real* value) {
        if (place.first_row >= 0 && is_parameter(model.materials[block.material], place.first_row))
          return set_point_parameter(model, block, lane, place.first_row, *value);
        for (int k = 0; k < place.n_rows && place.first_row >= 0; ++k) block.row(place.first_row + k)[lane] = value[k];
      });
  if (!has_started(state)) return;
  state.start_energy += kinetic_and_stored_energy(model, state) - before;
  for (const ActiveFollower& active : state.followers) active.follower->points_were_set(model, state);
}

StateImage Simulation::save() const { return make_image(state); }

void Simulation::restore(const StateImage& image)
{
  State saved = terp::restore(model, image);
  if (saved.n_ids() != state.n_ids())
    throw FileError(fmt::format(
        "the saved state is of another case: it has {} material points, this one {}", saved.n_ids(), state.n_ids()));
  const Real time = model.time_of(saved.step);
  if (std::abs(saved.time - time) > 1e-9 * model.dt * static_cast<Real>(std::max<std::int64_t>(saved.step, 1)))
    throw FileError(
        fmt::format("the saved state is of another case: its {} steps end at t = {:.6g} s, those of this one of "
                    "{:.4g} s at {:.6g} s",
            saved.step, saved.time, model.dt, time));
  state = std::move(saved);
  model = model_for(std::move(model), state);
  forget_water(work);
  work.fit(model, state);
}

}  // namespace terp
