// The mechanism that is kept is that of the smallest factor that did not stand. It goes when a later trial moves that
// end of the bracket.

#include "stability/factor_of_safety.hpp"

#include "base/errors.hpp"
#include "simulation/state_image.hpp"
#include "water/water_pressure.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace terp {
namespace {

/// A factor below one makes the soil stronger than the law may allow.
void check_strengths(const Case& reduced, Real factor)
{
  const auto faults = check_reduced(reduced);
  if (!faults.empty())
    throw RunError(fmt::format(
        "at the factor {:g} the strengths are not usable\n  {}\n  Choose --from and --to nearer to the answer.", factor,
        faults.front()));
}

}  // namespace

Real StabilityResult::factor() const
{
  return search.found() ? 0.5 * (*search.stable + *search.not_stable) : std::numeric_limits<Real>::quiet_NaN();
}

Real StabilityResult::uncertainty() const
{
  return search.found() ? std::max(factor() - *search.stable, *search.highest() - factor())
                        : std::numeric_limits<Real>::quiet_NaN();
}

void check_may_be_judged(const Case& c)
{
  if (const MaterialCase* material = find_not_judged(c)) {
    const MaterialType* law = find_material(material->model);
    throw InputError(Problem{fmt::format("material.{}.model", material->name),
        fmt::format("a factor of safety cannot be found for soil of the law {}", law->name),
        fmt::format("Because {}.\nGive `{}` another law, or leave it out: all soil of a case is judged together.",
            law->not_judged, material->name),
        "material", true});
  }
  if (strengths_of(quiet_case(c)).empty())
    throw InputError(Problem{"material", "no material of this case has a strength to reduce",
        "Elastic soil does not fail. `terp list` names the laws.", "material", true});
}

Trial try_factor(const Case& c, Real factor, const StabilityOptions& options, const std::atomic<bool>& stop)
{
  check_may_be_judged(c);
  const Trials trials(c, options.rules, options.threads, stop);
  check_strengths(reduce_strength(trials.quiet, factor), factor);
  return trials.run(factor);
}

StabilityResult find_factor_of_safety(
    const Case& c, const StabilityOptions& options, const std::atomic<bool>& stop, const TrialCallback& report)
{
  check_may_be_judged(c);
  const Trials trials(c, options.rules, options.threads, stop);
  const Case& quiet = trials.quiet;
  const ElasticStart& start = trials.start;
  StabilityResult result;
  result.options = options;
  result.strengths = strengths_of(quiet);
  result.slip_planes = quiet.slip_planes;
  if (quiet.water.is_given()) {
    const std::string& name = first_water(quiet.water).name;
    result.water = name.empty() ? std::string(name_of_start) : name;
    result.later_water = c.stages.empty() && knots_of(c.water).size() > 1;
  }
  result.mesh = trials.mesh;
  result.height = start.height;
  result.relief = start.relief;
  result.cell = start.cell;
  result.displacement = start.displacement;
  result.rest_steps = start.steps;
  result.n_points = count_points(start.rest);
  while (const auto factor = next_factor(result.search, options.search)) {
    check_strengths(reduce_strength(quiet, *factor), *factor);
    const int left = trials_left(result.search, options.search) - 1;
    const auto show = [&](const Trial& trial) {
      if (report) report(trial, result, left);
    };
    Trial trial = trials.run(*factor, show);
    result.stopped = stop.load();
    if (result.stopped) break;  // what the trial would have shown is not known
    const auto mechanism = std::exchange(trial.mechanism, nullptr);
    enter(std::move(trial), result.search);
    if (result.search.not_stable == *factor) result.mechanism = mechanism;
    if (result.mechanism && result.mechanism->factor != result.search.not_stable) result.mechanism = nullptr;
  }
  return result;
}

}  // namespace terp
