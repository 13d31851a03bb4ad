// A finding (one quantity of one run, with its reference and bounds) becomes a row. Quantities that compare runs are
// computed here, from all findings of one scheme. A fault costs its own row and no other: whatever cannot be measured
// or evaluated becomes a failed row with the reason.
#include "verify/judge.hpp"

#include "math/convergence.hpp"
#include "math/nan.hpp"
#include "io/case/case_file.hpp"
#include "verify/scope.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

std::string number(Real value, const std::string& unit)
{
  if (std::isnan(value)) return "never";
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string run_text(const std::string& run, const std::string& scheme)
{
  return run.empty() ? scheme : run + ", " + scheme;
}

/// The error to be judged: for a norm the norm itself; with `relative` over the reference.
Real error_of(const Finding& f)
{
  if (is_error(f.quantity->reduce)) return f.value;
  const Real distance = std::abs(f.value - f.reference);
  return std::isnan(f.relative) ? distance : distance / std::abs(f.reference);
}

/// A value that is not finite never agrees.
bool agrees(const Finding& f)
{
  if (!std::isfinite(f.value)) return false;
  if (!std::isnan(f.at_least)) return f.value >= f.at_least;
  if (!std::isnan(f.at_most)) return f.value <= f.at_most;
  return error_of(f) <= (std::isnan(f.relative) ? f.tolerance : f.relative);
}

/// Used share of the bound [-], 1 at the bound; -1 for a bound or value that is not positive.
Real share_of_bound(const Finding& f)
{
  const bool low = !std::isnan(f.at_least), high = !std::isnan(f.at_most);
  const Real part = low ? f.at_least : high ? f.value : error_of(f);
  const Real whole = low ? f.value : high ? f.at_most : std::isnan(f.relative) ? f.tolerance : f.relative;
  return std::isfinite(part) && part >= 0.0 && whole > 0.0 ? part / whole : -1.0;
}

bool declared_red(const Quantity& q, const std::string& run, const std::string& scheme)
{
  if (q.red.empty()) return false;
  return q.red_runs.empty() || std::ranges::any_of(q.red_runs, [&](const std::string& name) {
    return name == run || name == scheme || name == run + ", " + scheme;
  });
}

std::string why_none(const Finding& f)
{
  const Quantity& q = *f.quantity;
  if (q.kind == QuantityKind::order) return "no order: the errors of the runs, or their sizes, are equal or none";
  if (q.kind == QuantityKind::extrapolated) return "no limit: the differences of successive runs do not fall";
  if (q.reduce == Reduce::arrival) return "the threshold was not reached";
  if (q.reduce == Reduce::period || q.reduce == Reduce::frequency) return "there are no two upward crossings of zero";
  return "the formula, or a quantity in it, is not a finite number";
}

Row to_row(const std::string& case_name, const Finding& f)
{
  const Quantity& q = *f.quantity;
  const bool norm = is_error(q.reduce), bound = !std::isnan(f.at_least) || !std::isnan(f.at_most),
             relative = !std::isnan(f.relative);
  Row row{.case_name = case_name, .run = run_text(f.run, f.scheme), .quantity = q.name, .source = q.source};
  row.reference = norm ? q.reference.text : std::isnan(f.reference) ? "-" : number(f.reference, q.unit);
  if (norm && row.reference.empty()) row.reference = "0";
  if (!q.shown.empty()) row.reference = q.shown;
  row.terp = norm ? fmt::format("{} error {:.3g}", q.reduce == Reduce::rms_error ? "rms" : "largest", f.value)
                  : number(f.value, q.unit);
  row.error = bound      ? "-"
              : relative ? fmt::format("{:.2g} %", 100.0 * error_of(f))
                         : fmt::format("{:.2g}", error_of(f));
  row.tolerance = !std::isnan(f.at_least)  ? fmt::format("at least {:.3g}", f.at_least)
                  : !std::isnan(f.at_most) ? fmt::format("at most {:.3g}", f.at_most)
                  : relative               ? fmt::format("{:.3g} %", 100.0 * f.relative)
                                           : fmt::format("{:.3g}", f.tolerance);
  const bool good = agrees(f), known = declared_red(q, f.run, f.scheme);
  const bool excused = known && std::isfinite(f.value);  // the reason applies to a number, not to its absence
  row.declared_regression = !q.regression.empty();
  row.verdict = !good                     ? (excused ? Verdict::red : Verdict::fail)
                : row.declared_regression ? Verdict::regression
                                          : Verdict::pass;
  if (row.verdict == Verdict::regression) row.remark = q.regression;
  if (!good && excused) row.remark = q.red;
  if (!std::isfinite(f.value)) row.remark = why_none(f);
  row.declared_red = known;
  row.used = share_of_bound(f);
  return row;
}

std::vector<std::string> schemes_in(const std::vector<Finding>& findings)
{
  std::vector<std::string> schemes;
  for (const Finding& f : findings)
    if (std::ranges::find(schemes, f.scheme) == schemes.end()) schemes.push_back(f.scheme);
  return schemes;
}

bool concerns(const Quantity& order, const Finding& f)
{
  return f.fault.empty() && f.quantity->name == order.of && names_run(order.runs, f.run);
}

/// The runs of one scheme with their sizes and numbers, and the constants of the last.
struct Refinement {
  std::vector<Real> sizes = {}, numbers = {};
  Scope scope;
};

Refinement collect(
    const Expected& file, const Quantity& q, const std::string& scheme, const std::vector<Finding>& findings)
{
  Refinement runs{.scope = {.file = file}};
  const bool of_values = q.differences || needs_limit(q);
  for (const Finding& f : findings) {
    if (f.scheme != scheme || !concerns(q, f)) continue;
    runs.scope.constants = f.constants;
    runs.sizes.push_back(runs.scope.evaluate({q.over, q.place}));
    runs.numbers.push_back(of_values ? f.value : error_of(f));
  }
  return runs;
}

/// The order or the limit of the runs. A limit defines its uncertainty as the constant `gci`.
Real number_of(const Quantity& q, Refinement& runs)
{
  if (q.kind == QuantityKind::order)
    return q.differences ? observed_order(runs.sizes, runs.numbers) : log_slope(runs.sizes, runs.numbers);
  const Limit limit = q.order.text.empty() ? extrapolate(runs.sizes, runs.numbers)
                                           : extrapolate_by(runs.scope.evaluate(q.order), runs.sizes, runs.numbers);
  runs.scope.constants["gci"] = limit.uncertainty;
  return limit.value;
}

Finding find_by_bounds(
    const Quantity& q, const std::string& run, const std::string& scheme, Real value, const Scope& scope)
{
  Finding finding{
      .quantity = &q, .run = run, .scheme = scheme, .value = value, .reference = scope.evaluate_or(q.reference, nan)};
  read_bounds(scope, finding);
  return finding;
}

/// Each run of a scheme; its distance from the limit of the runs, times the safety factor, is the constant `gci`.
void add_runs_by_limit(const Quantity& q, const std::string& scheme, const std::vector<Finding>& findings,
    Refinement& runs, std::vector<Finding>& result)
{
  const Limit limit = extrapolate(runs.sizes, runs.numbers);
  for (const Finding& f : findings) {
    if (f.scheme != scheme || !concerns(q, f)) continue;
    runs.scope.constants = f.constants;
    runs.scope.constants["gci"] = safety_of_limit * std::abs(f.value - limit.value);
    result.push_back(find_by_bounds(q, f.run, scheme, f.value, runs.scope));
  }
}

/// A quantity from runs of refined cells, one finding per scheme; none where too few were made.
std::vector<Finding> compare_runs(const Expected& file, const Quantity& q, const std::vector<Finding>& findings)
{
  std::vector<Finding> result;
  for (const std::string& scheme : schemes_in(findings)) {
    Refinement runs = collect(file, q, scheme, findings);
    if (std::ssize(runs.sizes) < least_runs(q)) continue;
    if (q.kind == QuantityKind::mesh_error) {
      add_runs_by_limit(q, scheme, findings, runs, result);
    } else {
      const Real value = number_of(q, runs);
      result.push_back(find_by_bounds(q, fmt::format("over {}", q.over), scheme, value, runs.scope));
    }
  }
  return result;
}

/// A formula that cannot be evaluated fails this row, not those of the runs.
void add_comparison(const std::string& case_name, const Expected& file, const Quantity& q,
    const std::vector<Finding>& findings, std::vector<Row>& rows)
{
  try {
    for (const Finding& f : compare_runs(file, q, findings)) rows.push_back(to_row(case_name, f));
  } catch (const CaseError& error) {
    rows.push_back(fault_row(case_name, fmt::format("over {}", q.over), q.name, error.what()));
  }
}

}  // namespace

Row fault_row(
    const std::string& case_name, const std::string& run, const std::string& quantity, const std::string& fault)
{
  return {.case_name = case_name,
      .run = run,
      .quantity = quantity,
      .reference = "-",
      .terp = "no result",
      .error = "-",
      .tolerance = "-",
      .verdict = Verdict::fail,
      .remark = fault};
}

std::vector<Row> judge(const std::string& case_name, const Expected& file, const std::vector<Solve>& solves,
    const std::vector<Solved>& solved)
{
  std::vector<Row> rows;
  std::vector<Finding> findings;
  for (std::size_t k = 0; k < solved.size(); ++k) {
    if (!solved[k].fault.empty())
      rows.push_back(
          fault_row(case_name, run_text(solves[k].variant->name, solves[k].scheme), "the run", solved[k].fault));
    findings.insert(findings.end(), solved[k].findings.begin(), solved[k].findings.end());
  }
  for (const Quantity& q : file.quantities) {
    if (compares_runs(q)) add_comparison(case_name, file, q, findings, rows);
    for (const Finding& f : findings)
      if (f.quantity == &q)
        rows.push_back(
            f.fault.empty() ? to_row(case_name, f) : fault_row(case_name, run_text(f.run, f.scheme), q.name, f.fault));
  }
  return rows;
}

}  // namespace terp
