// The time of a step is measured on the simulation itself, whose state moves on; some steps before warm the caches. The
// whole run is taken to cost more per step than its start, since soil that fails returns to the yield surface. Memory
// is counted from the sizes of what is held, not measured.

#include "cli/cost.hpp"

#include "math/errors.hpp"
#include "run/report/output_costs.hpp"
#include "mpm/step/passes.hpp"
#include "mpm/step/workspace.hpp"
#include "os/say.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::int64_t fewest_steps = 5, most_needed = 20;  // of a trial: as many as points move a million times
constexpr double failing = 1.2;  // steps of a run over those of its trial: soil that fails returns to the yield surface

}  // namespace

double time_a_step(Simulation& s, double trial_seconds)
{
  using Clock = std::chrono::steady_clock;
  const auto make = [&](const StepPolicy& policy) {
    if (const StepsMade made = make_steps(s.model, s.state, s.work, policy); made.end == LoopEnd::fault)
      throw RunError(made.fault);
  };
  make({.most_steps = 2});  // warm caches, wake threads
  const std::int64_t needed = std::clamp<std::int64_t>(
      1'000'000 / std::max<std::int64_t>(s.state.points.n_points(), 1), fewest_steps, most_needed);
  const auto start = Clock::now();
  double seconds = 0.0;
  std::int64_t n = 0;
  make({.most_steps = s.model.n_steps, .after_step = [&] {
          seconds = std::chrono::duration<double>(Clock::now() - start).count();
          return ++n < needed || seconds < trial_seconds;
        }});
  return seconds / static_cast<double>(n);
}

double seconds_of_steps(const Model& model, double step_s)
{
  return failing * step_s * static_cast<double>(model.n_steps);
}

std::int64_t bytes_of(const Model& model, const State& state)
{
  constexpr std::int64_t per_cell_of_the_mesh = 160,
                         per_point = 27;  // of the mesh, counted; first place, audit and flags by id
  const auto cells = static_cast<std::int64_t>(state.points.occupied().size());
  const std::int64_t gauss =
      model.scheme->keeps_gauss_values
          ? sizeof(GaussValues<Quad4>) + Quad4::n_gauss * sizeof(Real) * (model.rows.n_rows() - Rows::state)
          : sizeof(Real);
  return state.points.bytes() + per_point * state.points.n_points() + per_cell_of_the_mesh * model.mesh->n_cells() +
         cells * (std::int64_t{sizeof(CornerSums<Quad4>) + sizeof(NodeValues)} + gauss);
}

double expected_seconds(Simulation& simulation, double trial_seconds)
{
  const double output_s = estimate_output(simulation.model, simulation.state).seconds;
  try {
    return seconds_of_steps(simulation.model, time_a_step(simulation, trial_seconds)) + output_s;
  } catch (const RunError&) {
    return 0.0;  // the run itself says so
  }
}

void print_passes(const Workspace& work)
{
  double total = 0.0;
  for (const double s : work.seconds) total += s;
  for (int pass = 0; pass < n_passes; ++pass)
    say("  {:<16} {:8.2f} s  {:4.1f} %\n", pass_names[pass], work.seconds[pass], 100.0 * work.seconds[pass] / total);
}

}  // namespace terp
