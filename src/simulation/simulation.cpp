// Steps are counted over the whole run. Each call of the loop ends at a step of that count or at the end of a stage.
// Only the last stage may be driven beyond its end. The step of a time is rounded up, less round-off: a time that is a
// multiple of dt would else fall one step later. A saved state must agree with this case in its points and in the time
// of its step. What hangs on the stage and on the water is then made anew from it: model, damping, nodal water, sizes
// of the workspace.

#include "simulation/simulation.hpp"

#include "base/errors.hpp"
#include "simulation/point_fields.hpp"
#include "simulation/stages.hpp"
#include "simulation/state_image.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

Model with_followers(Model model, const FollowerTypes& followers)
{
  model.followers = followers;
  return model;
}

}  // namespace

Simulation::Simulation(const Case& description, int threads, const FollowerTypes& followers)
    : model(with_followers(build_model(description, threads), followers)), state(build_state(model)), work(model, state)
{
  model.threads = work.threads.count();
}

Simulation::Simulation(const Case& description, SharedMesh mesh, int threads, const FollowerTypes& followers)
    : model(with_followers(build_model(description, std::move(mesh), threads), followers)),
      state(build_state(model)),
      work(model, state)
{
  model.threads = work.threads.count();
}

Simulation::Simulation(Model ready_model, State ready_state)
    : model(model_for(std::move(ready_model), ready_state)), state(std::move(ready_state)), work(model, state)
{
  model.threads = work.threads.count();
}

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

PointField Simulation::field(const std::string& name) const { return get_point_field(model, state, name); }

void Simulation::set_field(const std::string& name, const std::vector<Real>& values)
{
  set_point_field(model, name, values, state);
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
  work.damping_local = model.damping.local;
  work.forget_water();
  work.fit(model, state);
}

}  // namespace terp
