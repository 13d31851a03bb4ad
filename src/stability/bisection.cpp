#include "stability/bisection.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real stride = 1.5;      // between factors until a bracket is found
constexpr Real round_off = 1e-9;  // of the tolerance

}  // namespace

std::optional<Real> next_factor(const Bisection& so_far, const BisectionOptions& options)
{
  if (so_far.found()) {
    const Real low = *so_far.stable, high = *so_far.failed;
    return high - low > options.tolerance * (1.0 + round_off) ? std::optional(0.5 * (low + high)) : std::nullopt;
  }
  if (so_far.stable) {
    if (options.to && *options.to > *so_far.stable) return options.to;
    const Real next = *so_far.stable * stride;
    return next <= greatest_factor ? std::optional(next) : std::nullopt;
  }
  if (so_far.failed) {
    if (options.from && *options.from < *so_far.failed) return options.from;
    const Real next = *so_far.failed / stride;
    return next >= least_factor ? std::optional(next) : std::nullopt;
  }
  return options.from.value_or(options.to.value_or(1.0));
}

int trials_left(const Bisection& so_far, const BisectionOptions& options)
{
  const Real low = so_far.stable.value_or(options.from.value_or(so_far.failed.value_or(1.5) / stride));
  const Real high = so_far.failed.value_or(options.to.value_or(low * stride));
  const Real halvings = std::log2(std::max(1.0, (high - low) / options.tolerance));
  return static_cast<int>(std::ceil(halvings)) + (so_far.stable ? 0 : 1) + (so_far.failed ? 0 : 1);
}

void enter(Trial trial, Bisection& bisection)
{
  std::optional<Real>& end = trial.verdict == TrialVerdict::stable ? bisection.stable : bisection.failed;
  const bool nearer = !end || (trial.verdict == TrialVerdict::stable ? trial.factor > *end : trial.factor < *end);
  if (nearer) end = trial.factor;
  bisection.trials.push_back(std::move(trial));
}

}  // namespace terp
