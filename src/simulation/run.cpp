#include "simulation/run.hpp"

#include "base/errors.hpp"
#include "parallel/instructions.hpp"
#include "parallel/processor.hpp"
#include "simulation/failure.hpp"
#include "simulation/footings.hpp"
#include "simulation/frame.hpp"
#include "simulation/guards.hpp"
#include "simulation/initial.hpp"
#include "simulation/ledger.hpp"
#include "simulation/reached_sides.hpp"
#include "simulation/state_image.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr double progress_every = 0.25;  // of wall time [s]

/// Keeps the evidence of a run that must stop, and stops it.
[[noreturn]] void stop_run(const State& state, std::span<Observer* const> observers, std::string message)
{
  for (Observer* observer : observers) {
    const std::string saved = observer->save_failed(make_image(state));
    if (!saved.empty()) message += "\n  saved    " + saved;
  }
  throw RunError(message);
}

struct Loop {
  const Model& model;
  State& state;
  Workspace& work;
  std::span<Observer* const> observers;
  Clock::time_point start = Clock::now();
  double last_progress = -progress_every;
  double wall_before = 0.0;
  std::int64_t first_step = 0;
  std::vector<PointPlace> history_places = {};

  template <class F>
  void tell(F&& f) const
  {
    for (Observer* observer : observers) f(*observer);
  }

  void write_due(bool last)
  {
    const OutputCase& output = model.description.output;
    const auto now = [&](Real every) { return last || state.step == 0 || due(state.step, model.dt, every); };
    if (now(output.ledger_every)) tell_left();
    if (now(output.ledger_every)) write_ledger();
    if (now(output.ledger_every) && !model.footings.empty())
      tell([rows = keep_footings(model, state)](Observer& o) { o.footings(rows); });
    if (now(output.history_every))
      tell([rows = make_history(model, state, history_places)](Observer& o) { o.history(rows); });
    if (now(output.fields_every)) {
      state.softened_fraction.emplace_back(state.time, softened_fraction(model, state));
      tell_frame();
    }
    if (last || (state.step > 0 && due(state.step, model.dt, output.checkpoint_every))) write_checkpoint();
  }

  void write_ledger()
  {
    const LedgerRow row = keep_ledger(model, state, work);
    follow_sides(model, state);
    tell([&](Observer& o) { o.ledger(row); });
    if (!std::isfinite(row.kinetic + row.elastic))
      stop_run(state, observers, describe_not_finite(model, state, work, row.v_999));
    if (const std::string fault = find_fault_in_balance(model, state, row); !fault.empty())
      stop_run(state, observers, fault);
  }

  /// The points that left through open sides since this was last called.
  void tell_left()
  {
    if (state.left_told == state.left.size()) return;
    const std::vector<LeftPoint> fresh(
        state.left.begin() + static_cast<std::ptrdiff_t>(state.left_told), state.left.end());
    tell([&](Observer& o) { o.left(fresh); });
    state.left_told = state.left.size();
  }

  void tell_frame()
  {
    const std::int64_t n = state.n_ids(), step = n > most_points_at_once ? points_per_part : n;
    for (std::int64_t first = 0; first < n; first += step)
      tell([part = std::make_shared<const Frame>(make_frame(model, state, first, std::min(step, n - first)))](
               Observer& o) { o.frame(part); });
  }

  void write_checkpoint()
  {
    tell_left();
    state.wall_s = wall_before + seconds_since(start);
    for_each_part(state, most_values_of_part(state), [&](StateImage part) {
      tell([image = std::make_shared<const StateImage>(std::move(part))](Observer& o) { o.checkpoint(image); });
    });
  }

  void tell_progress(bool last)
  {
    const double wall = seconds_since(start);
    if (!last && wall - last_progress < progress_every) return;
    last_progress = wall;
    const auto done = static_cast<double>(state.step - first_step);
    const double rate = wall > 0.0 ? done * static_cast<double>(state.points.n_points()) / wall : 0.0;
    const double eta = done > 0.0 ? wall / done * static_cast<double>(model.n_steps - state.step) : 0.0;
    tell([&](Observer& o) {
      o.progress({state.time, model.description.time.end, state.step, model.n_steps, state.points.n_points(), wall,
          rate, eta});
    });
  }
};

/// What comes before the first step; reached: the first step may be made.
Search start_run(const Model& model, State& state, Workspace& work, const std::atomic<bool>& stop)
{
  start_audit(model, state);  // sizes what a checkpoint holds, before anything can stop the search
  if (model.description.initial.stress == InitialStress::equilibrium)
    if (Search search = seek_equilibrium(model, state, work, stop); !search.reached) return search;
  state.start_energy = kinetic_and_elastic_energy(model, state);
  start_audit(model, state);
  return {.reached = true};
}

}  // namespace

bool due(std::int64_t step, Real dt, Real every)
{
  if (every <= 0.0) return false;
  const Real multiple = std::round(static_cast<Real>(step) * dt / every);
  return std::llround(multiple * every / dt) == step;
}

std::int64_t count_due(std::int64_t step, Real dt, Real every)
{
  std::int64_t n = 0;
  for (std::int64_t k = 0; k <= step; ++k) n += due(k, dt, every) ? 1 : 0;
  return n;
}

StepsMade make_steps(const Model& model, State& state, Workspace& work, const StepPolicy& policy)
{
  for (std::int64_t n = 0; n < policy.most_steps; ++n) {
    const bool may_stop = policy.stop != nullptr && n >= policy.least_steps;
    if (may_stop && policy.stop->load(std::memory_order_relaxed)) return {.end = LoopEnd::stopped};
    model.step(model, state, work);
    if (policy.clock_stands) state.step = 0, state.time = 0.0;
    if (std::string fault = find_fault(model, state, work, state.largest_v_999); !fault.empty())
      return {.end = LoopEnd::fault, .fault = std::move(fault)};
    if (policy.after_step && !policy.after_step()) return {.end = LoopEnd::enough};
  }
  return {.end = LoopEnd::all_steps};
}

bool has_started(const State& state) { return state.step > 0 || state.ledger_rows > 0; }

Outcome run(const Model& model, State& state, Workspace& work, std::span<Observer* const> observers,
    const std::atomic<bool>& stop, std::int64_t until)
{
  Loop loop{.model = model,
      .state = state,
      .work = work,
      .observers = observers,
      .wall_before = state.wall_s,
      .first_step = state.step};
  if (!has_started(state)) {
    const Search search = start_run(model, state, work, stop);
    if (!search.fault.empty()) stop_run(state, observers, search.fault);
    if (!search.reached) {
      loop.write_checkpoint();
      return Outcome::interrupted;
    }
    loop.write_due(false);
  }
  const auto write_what_is_due = [&] {
    loop.write_due(state.step == model.n_steps);
    loop.tell_progress(state.step == model.n_steps);
    return true;
  };
  const StepsMade made = make_steps(model, state, work,
      {.most_steps = until - state.step,
          .stop = &stop,
          .least_steps = state.step == 0 ? 1 : 0,  // a checkpoint of step 0 is that of a search that goes on
          .after_step = write_what_is_due});
  if (made.end == LoopEnd::fault) stop_run(state, observers, made.fault);
  if (made.end == LoopEnd::stopped) loop.write_checkpoint();
  state.wall_s = loop.wall_before + seconds_since(loop.start);
  return made.end == LoopEnd::stopped ? Outcome::interrupted : Outcome::finished;
}

Summary summarise(const Model& model, const State& state)
{
  Summary s;
  s.scheme = model.description.scheme;
  s.n_points = state.points.n_points();
  s.n_cells = model.mesh->n_cells();
  s.n_steps = state.step;
  s.dt = model.dt;
  s.wall_s = state.wall_s;
  s.point_steps_per_s =
      state.wall_s > 0.0 ? static_cast<double>(s.n_points) * static_cast<double>(s.n_steps) / state.wall_s : 0.0;
  s.threads = model.threads;
  s.instructions = instructions();
  s.processor = processor_name();
  summarise_failure(model, state, s);
  const auto& eps = state.audit.last_eps_eq_p;
  s.max_eps_eq_p = eps.empty() ? 0.0 : *std::max_element(eps.begin(), eps.end());
  s.softened_fraction = state.softened_fraction;
  s.points_eps_eq_p_fell = std::count(state.audit.fell.begin(), state.audit.fell.end(), true);
  s.points_su_rose = std::count(state.audit.rose.begin(), state.audit.rose.end(), true);
  const WorkTotals& w = state.work;
  const Real exchanged = energy_exchanged(state);
  // Velocities are those of half a step before the places, so half of the last step's work is not yet in the kinetic
  // energy (docs/methods.md, section 5).
  const Real half_step = 0.5 * w.last_step;
  const Real numerical = kinetic_and_elastic_energy(model, state) + half_step + w.plastic - state.start_energy -
                         (w.gravity + w.damping + w.boundary);
  s.energy_balance_error = exchanged > 0.0 ? std::abs(numerical) / exchanged : 0.0;
  s.clamped_points = state.clamped;
  s.reached_sides = list_reached_sides(model, state);
  s.points_left = static_cast<std::int64_t>(state.left.size());
  for (std::size_t k = 0; k < model.footings.size(); ++k) {
    const FootingMeter& meter = state.footings[k];
    s.footings.push_back({model.footings[k].name, model.footings[k].displacement(state.time), meter.reaction,
        meter.largest, meter.work});
  }
  s.v_999 = state.largest_v_999;
  return s;
}

}  // namespace terp
