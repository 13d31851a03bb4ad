#include "stability/trial.hpp"

#include "base/errors.hpp"
#include "simulation/guards.hpp"
#include "simulation/setup.hpp"
#include "simulation/state_image.hpp"
#include "stability/reduce.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

using Rows = PointRows<2>;

constexpr Real window_traversals = 2.0;  // down and up

/// Mean displacement of the one per cent of the points that moved furthest [m].
Real largest_displacement(const State& state)
{
  std::vector<Real> way;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    way.push_back(std::hypot(block.row(Rows::x)[lane] - state.x_initial[2 * id], block.row(Rows::x + 1)[lane] - state.x_initial[2 * id + 1]));
  });
  const std::size_t n = std::max<std::size_t>(1, way.size() / 100);
  if (way.size() < n) return 0.0;
  std::nth_element(way.begin(), way.end() - static_cast<std::ptrdiff_t>(n), way.end());
  Real sum = 0.0;
  for (auto w = way.end() - static_cast<std::ptrdiff_t>(n); w != way.end(); ++w) sum += *w;
  return sum / static_cast<Real>(n);
}

std::string reason_of(const Trial& trial, Real displacement)
{
  const TrialWindow& last = trial.windows.back();
  const std::string text = fmt::format("out of balance {:.1e} of the weight, displacement {:.3g} m = {:.2f} rho g H^2/E", last.out_of_balance, last.displacement,
                                       last.displacement / displacement);
  switch (trial.verdict) {
    case TrialVerdict::stable: return "at rest: " + text;
    case TrialVerdict::failed: return "runs away: " + text;
    case TrialVerdict::undecided: break;
  }
  return "creeps: " + text;
}

/// The trial's model: no shorter in time than its windows may take.
Model build_trial(Case c, const Mesh<2>& mesh, const ElasticStart& start, const TrialRules& rules, int threads)
{
  c.forces.local_damping = rules.damping;
  c.time.end = window_traversals * start.traversal * rules.most_windows;
  return build_model(c, mesh, threads);
}

}  // namespace

TrialVerdict judge(const std::vector<TrialWindow>& windows, const TrialRules& rules, Real displacement)
{
  if (windows.empty()) return TrialVerdict::undecided;
  const TrialWindow& last = windows.back();
  if (last.out_of_balance < rules.rest) return TrialVerdict::stable;
  if (windows.size() < 3) return TrialVerdict::undecided;
  const Real before = windows[windows.size() - 2].displacement, first = windows[windows.size() - 3].displacement;
  const bool slows_down = last.displacement - before < 0.98 * (before - first);
  return last.displacement > rules.failure * displacement && !slows_down ? TrialVerdict::failed : TrialVerdict::undecided;
}

Trial run_trial(const Case& quiet, const Mesh<2>& mesh, const ElasticStart& start, Real factor, const TrialRules& rules, int threads,
                const std::atomic<bool>& stop, const std::function<void(const Trial&)>& told)
{
  const auto began = std::chrono::steady_clock::now();
  const Model model = build_trial(reduce_strength(quiet, factor), mesh, start, rules, threads);
  State state = restore(model, start.rest);
  Workspace work(model, state);
  Trial trial;
  trial.factor = factor;
  const std::int64_t per_window = std::max<std::int64_t>(1, model.n_steps / rules.most_windows);
  while (std::ssize(trial.windows) < rules.most_windows && trial.verdict == TrialVerdict::undecided) {
    Real out_of_balance = 0.0;
    for (std::int64_t k = 0; k < per_window; ++k) {
      if (stop.load(std::memory_order_relaxed)) throw RunError("stopped before a factor was found");
      model.step(model, state, work);
      out_of_balance += work.unbalanced_ratio;
      if (const std::string fault = find_fault(model, state, work, 0.0); !fault.empty()) {
        trial.verdict = TrialVerdict::failed;
        trial.reason = "runs away until the run stops itself: " + fault.substr(0, fault.find('\n'));
        told(trial);
        return trial;
      }
    }
    trial.windows.push_back({state.time, largest_displacement(state), out_of_balance / static_cast<Real>(per_window)});
    trial.steps = state.step;
    trial.verdict = judge(trial.windows, rules, start.displacement);
    trial.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (trial.verdict != TrialVerdict::undecided || std::ssize(trial.windows) == rules.most_windows) trial.reason = reason_of(trial, start.displacement);
    told(trial);
  }
  return trial;
}

}  // namespace terp
