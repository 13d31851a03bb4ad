// The bracket is made anew from all trials whenever one is entered: a factor that fails takes all that stood above it
// out of the count. So stable < not_stable <= failed at any time. A trial that is undecided bounds the factor from
// above as a failure does; only after that bracket is narrow enough are factors above it tried.

#include "run/stability/bisection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

constexpr Real stride = 1.5;      // between factors until a bracket is found
constexpr Real round_off = 1e-9;  // of the tolerance

constexpr Real stride_of_creep = 1.1;  // between factors beyond one that crept, until one fails
constexpr Real most_creep = 1.5;       // over the largest factor that stood: beyond, nothing is sought any more

/// Largest factor below those that failed whose trial was undecided; without any the smallest that did not stand.
Real largest_undecided(const Bisection& so_far)
{
  Real most = 0.0;
  for (const Trial& t : so_far.trials)
    if (t.verdict == TrialVerdict::undecided && !(so_far.failed && t.factor >= *so_far.failed))
      most = std::max(most, t.factor);
  return most > so_far.stable.value_or(0.0) ? most : *so_far.not_stable;
}

/// What bounds the factor from above where the smallest that did not stand only crept.
std::optional<Real> next_above_creep(const Bisection& so_far, const BisectionOptions& options)
{
  const Real crept = largest_undecided(so_far);
  if (so_far.failed)
    return *so_far.failed - crept > options.width_at(crept) * (1.0 + round_off)
               ? std::optional(0.5 * (crept + *so_far.failed))
               : std::nullopt;
  const Real next = stride_of_creep * crept;
  return next <= std::min(greatest_factor, most_creep * *so_far.stable) ? std::optional(next) : std::nullopt;
}

}  // namespace

std::optional<Real> Bisection::highest() const
{
  if (failed) return failed;
  std::optional<Real> most;
  for (const Trial& trial : trials)
    if (trial.verdict == TrialVerdict::undecided && !(trial.factor <= most.value_or(0.0))) most = trial.factor;
  return most;
}

std::optional<Real> next_factor(const Bisection& so_far, const BisectionOptions& options)
{
  if (so_far.found()) {
    const Real low = *so_far.stable, high = *so_far.not_stable;
    return high - low > options.width_at(low) * (1.0 + round_off) ? std::optional(0.5 * (low + high))
                                                                  : next_above_creep(so_far, options);
  }
  if (so_far.stable) {
    if (options.to && *options.to > *so_far.stable) return options.to;
    const Real next = *so_far.stable * stride;
    return next <= greatest_factor ? std::optional(next) : std::nullopt;
  }
  if (so_far.not_stable) {
    if (options.from && *options.from < *so_far.not_stable) return options.from;
    const Real next = *so_far.not_stable / stride;
    return next >= least_factor ? std::optional(next) : std::nullopt;
  }
  return options.from.value_or(options.to.value_or(1.0));
}

int trials_left(const Bisection& so_far, const BisectionOptions& options)
{
  const Real low = so_far.stable.value_or(options.from.value_or(so_far.not_stable.value_or(1.5) / stride));
  const Real high = so_far.not_stable.value_or(options.to.value_or(low * stride));
  const auto halvings = [&](Real a, Real b) {
    return static_cast<int>(std::ceil(std::log2(std::max(1.0, (b - a) / options.width_at(a)))));
  };
  return halvings(low, high) + (so_far.failed ? halvings(largest_undecided(so_far), *so_far.failed) : 0) +
         (so_far.stable ? 0 : 1) + (so_far.not_stable ? 0 : 1);
}

void enter(Trial trial, Bisection& bisection)
{
  bisection.trials.push_back(std::move(trial));
  bisection.stable = bisection.not_stable = bisection.failed = std::nullopt;
  const auto lower = [](std::optional<Real>& least, Real factor) { least = std::min(least.value_or(factor), factor); };
  for (const Trial& t : bisection.trials)
    if (t.verdict == TrialVerdict::failed) lower(bisection.failed, t.factor);
  const Real most = bisection.failed.value_or(std::numeric_limits<Real>::infinity());
  for (const Trial& t : bisection.trials)
    if (t.verdict == TrialVerdict::stable && t.factor < most)
      bisection.stable = std::max(bisection.stable.value_or(t.factor), t.factor);
  bisection.not_stable = bisection.failed;
  for (const Trial& t : bisection.trials)
    if (t.verdict == TrialVerdict::undecided && t.factor > bisection.stable.value_or(0.0) && t.factor < most)
      lower(bisection.not_stable, t.factor);
}

}  // namespace terp
