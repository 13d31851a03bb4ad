// A run that the guards stop has failed. The soil is stiffened; times and displacements of the windows are turned back
// to those of the soil as it is.

#include "run/stability/trial.hpp"

#include "model/soils/point_parameters.hpp"
#include "model/parts/reduce.hpp"
#include "run/loop/run.hpp"
#include "model/parts/setup.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "run/report/state_image.hpp"
#include "run/stability/soil_motion.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::ptrdiff_t windows_at_rest = 3;  // in a row: a trial that pauses and goes on does not stand yet

std::string reason_of(const Trial& trial, Real displacement)
{
  const TrialWindow& last = trial.windows.back();
  const std::string text =
      fmt::format("out of balance {:.1e} of the weight, displacement {:.3g} m = {:.2f} rho g H^2/E",
          last.out_of_balance, last.displacement, last.displacement / displacement);
  switch (trial.verdict) {
    case TrialVerdict::stable: return "at rest: " + text;
    case TrialVerdict::failed: return "runs away: " + text;
    case TrialVerdict::undecided: break;
  }
  return "creeps: " + text;
}

/// The trial's model: no shorter in time than its windows may take.
Model build_trial(const Trials& of, Real factor)
{
  Case c = reduce_strength(stiffen(of.quiet, of.start.stiffening), factor);
  c.forces.local_damping = of.rules.damping;
  c.forces.averaging_time = 0.0;
  c.water.follow_soil = false;  // the water of the rest
  c.time.end = window_traversals * of.start.traversal / std::sqrt(of.start.stiffening) * of.rules.most_windows;
  return build_model(c, of.mesh, of.threads);
}

/// The points at the ends of the last two windows, the later one last.
class LastWindows {
 public:
  void enter(const State& state)
  {
    std::swap(before_, now_);
    now_ = look_at_points(state);
    ++n_;
  }

  /// Null with fewer than two windows.
  std::shared_ptr<const Mechanism> mechanism(
      const Model& model, const State& state, const Trials& of, Real factor) const
  {
    if (n_ < 2) return nullptr;
    Mechanism found = find_mechanism(model, state, before_, now_, of.judged, of.start.stiffening);
    found.factor = factor;
    return std::make_shared<const Mechanism>(std::move(found));
  }

 private:
  PointMotion before_, now_;
  int n_ = 0;
};

}  // namespace

TrialVerdict judge(const std::vector<TrialWindow>& windows, const TrialRules& rules, const ElasticStart& start)
{
  const std::ptrdiff_t n = std::ssize(windows);
  const auto moved = [&](std::ptrdiff_t back) {  // in the last window, the one before it, ...
    const std::ptrdiff_t k = n - 1 - back;
    return windows[k].displacement - (k > 0 ? windows[k - 1].displacement : 0.0);
  };
  if (n < windows_at_rest) return TrialVerdict::undecided;
  Real most = 0.0;
  for (std::ptrdiff_t back = 0; back < windows_at_rest; ++back) most = std::max(most, std::abs(moved(back)));
  if (most < rules.rest * start.free_motion) return TrialVerdict::stable;
  const bool far = windows.back().displacement > rules.failure * start.displacement;
  const bool moves_on = std::min(moved(0), moved(1)) > rules.rest * start.free_motion;  // not at rest, no rebound
  const bool slows_down = moved(0) < 0.98 * moved(1);
  return far && moves_on && !slows_down ? TrialVerdict::failed : TrialVerdict::undecided;
}

Trials::Trials(const Case& c, const TrialRules& of_all, int n_threads, const std::atomic<bool>& may_stop)
    : quiet(quiet_case(c)),
      mesh(std::make_shared<const Mesh<2>>(build_mesh(quiet))),
      start(settle_elastically(quiet, mesh, of_all.stiffening, n_threads, may_stop)),
      rules(of_all),
      threads(n_threads),
      stop(may_stop)
{
  if (!(rules.least_depth > 0.0)) return;
  const Model model = build_trial(*this, 1.0);
  judged = points_below(model, restore(model, start.rest), rules.least_depth);
}

Trial Trials::run(Real factor, const std::function<void(const Trial&)>& report) const
{
  const auto began = std::chrono::steady_clock::now();
  const Model model = build_trial(*this, factor);
  State state = restore(model, start.rest);
  set_point_parameters(model, start.seeds, state);  // reduced; the elastic soil did not look at them
  Workspace work(model, state);
  OutOfBalance balance(model);
  LastWindows last;
  Trial trial;
  trial.factor = factor;
  trial.threads = work.threads.count();
  const std::int64_t per_window = std::max<std::int64_t>(1, model.n_steps / rules.most_windows);
  const auto judge_window = [&] {
    trial.windows.push_back({state.time * std::sqrt(start.stiffening),
        displacement_of_the_fastest(state, judged) * start.stiffening, balance.take_share()});
    last.enter(state);
    trial.steps = state.step;
    trial.verdict = judge(trial.windows, rules, start);
    trial.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (trial.verdict != TrialVerdict::undecided || std::ssize(trial.windows) == rules.most_windows)
      trial.reason = reason_of(trial, start.displacement);
    report(trial);
    return trial.verdict == TrialVerdict::undecided;
  };
  const auto goes_on = [&] {
    balance.add_forces(model, work);
    return state.step % per_window != 0 || judge_window();
  };
  const StepsMade made = make_steps(
      model, state, work, {.most_steps = per_window * rules.most_windows, .stop = &stop, .after_step = goes_on});
  if (made.end == LoopEnd::fault) {
    trial.verdict = TrialVerdict::failed;
    trial.reason = "runs away until the run stops itself: " + made.fault.substr(0, made.fault.find('\n'));
    report(trial);
  }
  if (trial.verdict != TrialVerdict::stable) trial.mechanism = last.mechanism(model, state, *this, factor);
  return trial;
}

}  // namespace terp
