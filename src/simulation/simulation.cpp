#include "simulation/simulation.hpp"

#include "base/errors.hpp"
#include "simulation/point_fields.hpp"
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
    : model(std::move(ready_model)), state(std::move(ready_state)), work(model, state)
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
  return terp::run(model, state, work, observers, stop, state.step + n);
}

Outcome Simulation::advance_to(Real t, const std::atomic<bool>& stop)
{
  const Real step = std::ceil(t / model.dt * (1.0 - 1e-12));
  if (!(step >= static_cast<Real>(state.step) && step < static_cast<Real>(most_steps)))
    throw InputError(Problem{"advance_to", fmt::format("the run cannot advance to t = {} s", t),
        fmt::format("It is at t = {:.4g} s and makes steps of {:.4g} s. `restore` goes back to a saved state.",
            state.time, model.dt),
        ""});
  return terp::run(model, state, work, observers, stop, static_cast<std::int64_t>(step));
}

Outcome Simulation::run(const std::atomic<bool>& stop)
{
  return terp::run(model, state, work, observers, stop, model.n_steps);
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
  const Real time = static_cast<Real>(saved.step) * model.dt;
  if (std::abs(saved.time - time) > 1e-9 * model.dt * static_cast<Real>(std::max<std::int64_t>(saved.step, 1)))
    throw FileError(
        fmt::format("the saved state is of another case: its {} steps end at t = {:.6g} s, those of this one of "
                    "{:.4g} s at {:.6g} s",
            saved.step, saved.time, model.dt, time));
  state = std::move(saved);
  work.settling = false;
  work.damping_local = model.damping.local;
  work.fit(model, state);
}

}  // namespace terp
