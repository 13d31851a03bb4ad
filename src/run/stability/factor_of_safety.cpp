// Mechanisms are kept of the least factor that failed and of those below it that crept: which of them is the least that
// did not stand may still change.

#include "run/stability/factor_of_safety.hpp"

#include "math/errors.hpp"
#include "run/report/state_image.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <cmath>
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

/// Mechanisms of trials that did not stand, the frames of which are large: of those that a result may still need.
class Mechanisms {
 public:
  void enter(std::shared_ptr<const Mechanism> mechanism, const Bisection& search)
  {
    if (mechanism) kept_.push_back(std::move(mechanism));
    std::erase_if(kept_, [&](const auto& m) {
      return m->factor < search.stable.value_or(0.0) || (search.failed && m->factor > *search.failed);
    });
  }
  std::shared_ptr<const Mechanism> at(const std::optional<Real>& factor) const
  {
    const auto found = std::ranges::find_if(kept_, [&](const auto& m) { return factor == m->factor; });
    return found == kept_.end() ? nullptr : *found;
  }

 private:
  std::vector<std::shared_ptr<const Mechanism>> kept_;
};

}  // namespace

Case judged_case(Case c, const StabilityOptions& options)
{
  c = with_flow(std::move(c), options.flow);
  return options.cracks ? leave_out_tension(std::move(c)) : c;
}

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
  if (c.forces.body.changes)
    throw InputError(
        Problem{"forces.body", "a factor of safety cannot be found under a force that changes with the time",
            "Trials have times of their own. Give `bx` and `by` without t, as a level that stays.", "forces.body"});
  if (strengths_of(quiet_case(c)).empty())
    throw InputError(Problem{"material", "no material of this case has a strength to reduce",
        "Elastic soil does not fail. `terp list` names the laws.", "material", true});
}

Trial try_factor(const Case& c, Real factor, const StabilityOptions& options, const std::atomic<bool>& stop)
{
  check_may_be_judged(c);
  const Trials trials(judged_case(c, options), options.rules, options.threads, stop);
  check_strengths(reduce_strength(trials.quiet, factor), factor);
  return trials.run(factor);
}

std::optional<FactorLimit> StabilityResult::limit() const
{
  if (sizes.size() < 2 || stopped || !search.found() || is_upper_bound()) return std::nullopt;
  return extrapolate_factor(sizes);
}

bool StabilityResult::is_upper_bound() const
{
  if (!search.found()) return false;
  std::vector<SizedFactor> finest = sizes;
  std::ranges::sort(finest, {}, &SizedFactor::cell);
  if (finest.size() > 2) finest.resize(2);
  const auto is_few = [](const SizedFactor& size) { return size.cells_over_depth < fewest_cells; };
  return cells_over_depth() < fewest_cells || std::ranges::any_of(finest, is_few);
}

Real StabilityResult::answer() const
{
  if (const auto of_mesh = limit()) return of_mesh->factor;
  if (!is_upper_bound()) return factor();
  Real most = *search.highest();
  for (const SizedFactor& size : sizes) most = std::fmin(most, size.highest);
  return most;
}

Real StabilityResult::answer_uncertainty() const
{
  if (const auto of_mesh = limit()) return std::max(of_mesh->high - of_mesh->factor, of_mesh->factor - of_mesh->low);
  return is_upper_bound() ? std::max(answer() - *search.stable, 0.0) : uncertainty();
}

Real StabilityResult::cells_over_depth() const
{
  const auto moves = what_moves();
  return (moves && moves->moving ? moves->moving->depth : relief) / cell;
}

SizedFactor size_of(const StabilityResult& r)
{
  return {r.cell, r.factor(), r.uncertainty(), r.search.highest().value_or(std::numeric_limits<Real>::quiet_NaN()),
      r.cells_over_depth()};
}

StabilityResult find_factor_of_safety(
    const Case& c, const StabilityOptions& options, const std::atomic<bool>& stop, const TrialCallback& report)
{
  check_may_be_judged(c);
  const Trials trials(judged_case(c, options), options.rules, options.threads, stop);
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
  const MeshKind kind = c.mesh.kind;
  const bool by_mean = kind == MeshKind::graded || kind == MeshKind::mapped;
  result.given_cell = kind == MeshKind::file ? 0.0 : by_mean ? start.cell : c.mesh.cell[0];
  result.displacement = start.displacement;
  result.rest_steps = start.steps;
  result.n_points = count_points(start.rest);
  Mechanisms mechanisms;
  while (const auto factor = next_factor(result.search, options.search)) {
    check_strengths(reduce_strength(quiet, *factor), *factor);
    const int left = trials_left(result.search, options.search) - 1;
    const auto show = [&](const Trial& trial) {
      if (report) report(trial, result, left);
    };
    Trial trial = trials.run(*factor, show);
    result.stopped = stop.load();
    if (result.stopped) break;  // what the trial would have shown is not known
    auto mechanism = std::exchange(trial.mechanism, nullptr);
    enter(std::move(trial), result.search);
    mechanisms.enter(std::move(mechanism), result.search);
    result.mechanism = mechanisms.at(result.search.failed);
    result.creep = result.search.not_stable != result.search.failed ? mechanisms.at(result.search.not_stable) : nullptr;
  }
  return result;
}

std::optional<SizedFactor> find_factor_with_tension(
    const Case& c, const StabilityResult& cracked, const std::atomic<bool>& stop, const TrialCallback& report)
{
  const auto same = [](const MaterialCase& a, const MaterialCase& b) {
    const auto same_field = [](const ParameterField& x, const ParameterField& y) { return x.text == y.text; };
    return a.parameters == b.parameters && std::ranges::equal(a.fields, b.fields, same_field);
  };
  if (!cracked.search.found() || std::ranges::equal(c.materials, leave_out_tension(c).materials, same)) return {};
  StabilityOptions options = cracked.options;
  options.cracks = false;
  const Real next = (1.0 + much_tension) * cracked.factor();
  if (try_factor(c, next, options, stop).verdict != TrialVerdict::stable) return {};
  options.search.from = next;
  options.search.to.reset();
  const StabilityResult whole = find_factor_of_safety(c, options, stop, report);
  if (whole.stopped || !whole.search.found()) return {};
  return size_of(whole);
}

}  // namespace terp
