// Measures are asked for their numbers in the order of the file, so that later formulas may use earlier values. A
// search for a factor of safety takes the place of the run where the variant asks for one. Errors never leave this
// file: they become the fault of a finding, or of the whole run.
#include "verify/solve_variant.hpp"

#include "math/errors.hpp"
#include "math/nan.hpp"
#include "run/measure/followers.hpp"
#include "run/loop/simulation.hpp"
#include "run/stability/factor_of_safety.hpp"
#include "verify/measure.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <limits>

namespace terp {
namespace {

CaseFile read_solved_case(const Solve& solve)
{
  const auto folder = std::filesystem::path(solve.file->path).parent_path();
  std::vector<std::string> changes = solve.variant->set;
  if (!solve.scheme.empty()) changes.push_back("scheme=" + solve.scheme);
  return read_case((folder / solve.variant->case_file).string(), changes);
}

/// A formula that cannot be evaluated fails this finding and no other.
template <class F>
void guarded(Finding& finding, F&& f)
{
  if (!finding.fault.empty()) return;
  try {
    f();
  } catch (const CaseError& error) {
    finding.fault = error.what();
  }
}

Finding start_finding(const Quantity& q, const Solve& solve, const std::string& scheme, const Scope& scope)
{
  Finding f{.quantity = &q, .run = solve.variant->name, .scheme = scheme, .constants = scope.constants};
  guarded(f, [&] { read_bounds(scope, f); });
  return f;
}

std::vector<Finding> rows_of(std::vector<Finding> findings)
{
  std::erase_if(findings, [](const Finding& f) { return is_auxiliary(*f.quantity) && f.fault.empty(); });
  return findings;
}

std::vector<Finding> findings_of_factor(const Solve& solve, const CaseFile& solved, Scope& scope,
    std::vector<Finding> findings, const std::atomic<bool>& stop)
{
  const std::vector<Real>& bounds = solve.variant->stability;
  const StabilityResult result = find_factor_of_safety(solved.values,
      {.search = {.from = bounds[0], .to = bounds[1], .tolerance = bounds[2]},
          .rules = {.least_depth = solve.variant->least_depth},
          .threads = 1},
      stop);
  scope.constants["factor"] = result.factor();
  scope.constants["stable_at"] = result.search.stable.value_or(nan);
  scope.constants["not_stable_at"] = result.search.not_stable.value_or(nan);
  for (Finding& finding : findings)
    guarded(finding, [&, &f = finding] {
      if (f.quantity->kind != QuantityKind::formula)
        refuse(*solve.file, f.quantity->place, "a run for a factor of safety has quantities of kind `formula` only",
            "They may name factor, stable_at, not_stable_at.");
      f.value = scope.evaluate(f.quantity->value);
      f.reference = scope.evaluate_or(f.quantity->reference, nan);
      if (const std::string& name = f.quantity->as; !name.empty()) scope.constants[name] = f.value;
    });
  return rows_of(std::move(findings));
}

std::vector<Finding> solve_and_measure(const Solve& solve, const CaseFile& solved, const std::atomic<bool>& stop)
{
  Simulation simulation(solved.values, 1, all_followers());
  Scope scope = make_scope(*solve.file, *solve.variant, solved, simulation.model.dt);
  std::vector<Finding> findings;
  std::vector<std::unique_ptr<Measure>> measured;
  for (const Quantity& q : solve.file->quantities) {
    if (!measures(q, *solve.variant)) continue;
    findings.push_back(start_finding(q, solve, solved.values.scheme, scope));
    measured.push_back(make_measure(q, scope));
    simulation.observers.push_back(measured.back().get());
  }
  if (!solve.variant->stability.empty()) return findings_of_factor(solve, solved, scope, std::move(findings), stop);
  if (simulation.run(stop) == Outcome::interrupted) throw RunError("stopped");
  const Summary summary = summarise(simulation.model, simulation.state);
  for (std::size_t k = 0; k < findings.size(); ++k)
    guarded(findings[k], [&] {
      const Measured result = measured[k]->finish(summary);
      findings[k].value = result.value;
      findings[k].reference = result.reference;
      if (const std::string& name = findings[k].quantity->as; !name.empty()) scope.constants[name] = result.value;
    });
  return rows_of(std::move(findings));
}

}  // namespace

void read_bounds(const Scope& scope, Finding& f)
{
  const auto bound = [&](const Formula& formula, const char* name, Real least) {
    const Real value = scope.evaluate_or(formula, nan);
    if (formula.given() && !(std::isfinite(value) && value >= least))
      refuse(scope.file, formula.place,
          fmt::format("`{}` must be a finite number{}", name, least == 0.0 ? ", 0 or more" : ""),
          fmt::format("Got {}.", value));
    return value;
  };
  constexpr Real any = std::numeric_limits<Real>::lowest();
  const Quantity& q = *f.quantity;
  f.tolerance = bound(q.tolerance, "tolerance", 0.0), f.relative = bound(q.relative, "relative", 0.0);
  f.at_least = bound(q.at_least, "at_least", any), f.at_most = bound(q.at_most, "at_most", any);
}

bool measures(const Quantity& quantity, const Variant& variant)
{
  return !compares_runs(quantity) && names_run(quantity.runs, variant.name);
}

std::vector<Solve> list_solves(const Expected& file, bool with_short, bool with_long)
{
  std::vector<Solve> solves;
  for (const Variant& v : file.variants) {
    for (const std::string& scheme : v.schemes.empty() ? std::vector<std::string>{""} : v.schemes) {
      const bool is_long = v.is_long || std::ranges::find(v.long_schemes, scheme) != v.long_schemes.end();
      if (is_long ? with_long : with_short) solves.push_back({&file, &v, scheme});
    }
  }
  return solves;
}

Solved solve_variant(const Solve& solve, const std::atomic<bool>& stop)
{
  const auto start = std::chrono::steady_clock::now();
  Solved result;
  CaseFile solved;
  try {
    solved = read_solved_case(solve);
    result.findings = solve_and_measure(solve, solved, stop);
  } catch (const CaseError& error) {
    result.fault = error.what();
  } catch (const InputError& error) {
    result.fault = render(error.problems(), solved);
  } catch (const std::exception& error) {
    result.fault = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace terp
