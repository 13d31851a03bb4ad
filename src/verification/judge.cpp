#include "verification/judge.hpp"

#include "verification/scope.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace terp {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

std::string number(Real value, const std::string& unit)
{
  if (std::isnan(value)) return "never";
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string run_text(const std::string& run, const std::string& scheme) { return run.empty() ? scheme : run + ", " + scheme; }

/// The distance that is judged: of a norm, the norm itself; with `relative`, over the reference.
Real error_of(const Finding& f)
{
  if (is_error(f.quantity->reduce)) return f.value;
  const Real distance = std::abs(f.value - f.reference);
  return std::isnan(f.relative) ? distance : distance / std::abs(f.reference);
}

bool agrees(const Finding& f)
{
  if (!std::isnan(f.at_least)) return f.value >= f.at_least;
  if (!std::isnan(f.at_most)) return f.value <= f.at_most;
  return error_of(f) <= (std::isnan(f.relative) ? f.tolerance : f.relative);
}

/// An empty list names all.
bool names_run(const std::vector<std::string>& runs, const std::string& run)
{
  return runs.empty() || std::find(runs.begin(), runs.end(), run) != runs.end();
}

Row to_row(const std::string& case_name, const Finding& f)
{
  const Quantity& q = *f.quantity;
  const bool norm = is_error(q.reduce), bound = !std::isnan(f.at_least) || !std::isnan(f.at_most), relative = !std::isnan(f.relative);
  Row row{.case_name = case_name, .run = run_text(f.run, f.scheme), .quantity = q.name, .source = q.source};
  row.reference = norm ? q.reference.text : std::isnan(f.reference) ? "-" : number(f.reference, q.unit);
  if (norm && row.reference.empty()) row.reference = "0";
  if (!q.shown.empty()) row.reference = q.shown;
  row.terp = norm ? fmt::format("{} error {:.3g}", q.reduce == Reduce::rms_error ? "rms" : "largest", f.value) : number(f.value, q.unit);
  row.error = bound ? "-" : relative ? fmt::format("{:.2g} %", 100.0 * error_of(f)) : fmt::format("{:.2g}", error_of(f));
  row.tolerance = !std::isnan(f.at_least)  ? fmt::format("at least {:.3g}", f.at_least)
                  : !std::isnan(f.at_most) ? fmt::format("at most {:.3g}", f.at_most)
                  : relative               ? fmt::format("{:.3g} %", 100.0 * f.relative)
                                           : fmt::format("{:.3g}", f.tolerance);
  const bool good = agrees(f), known = !q.red.empty() && names_run(q.red_runs, f.run);
  row.verdict = good ? Verdict::pass : known ? Verdict::red : Verdict::fail;
  if (!good && known) row.remark = q.red;
  return row;
}

/// A run that gave no numbers: one row for all its quantities.
Row row_of_fault(const std::string& case_name, const Solve& solve, const std::string& fault)
{
  return {.case_name = case_name, .run = run_text(solve.variant->name, solve.scheme), .quantity = "the run", .reference = "-", .source = "",
          .terp = "no result", .error = "-", .tolerance = "-", .verdict = Verdict::fail, .remark = fault};
}

std::vector<std::string> schemes_in(const std::vector<Finding>& findings)
{
  std::vector<std::string> schemes;
  for (const Finding& f : findings)
    if (std::find(schemes.begin(), schemes.end(), f.scheme) == schemes.end()) schemes.push_back(f.scheme);
  return schemes;
}

bool concerns(const Quantity& order, const Finding& f)
{
  return f.quantity->name == order.of && names_run(order.runs, f.run);
}

/// Order of convergence of a quantity's error, one finding per scheme; none where fewer than two runs were made.
std::vector<Finding> orders(const Expected& file, const Quantity& order, const std::vector<Finding>& findings)
{
  std::vector<Finding> result;
  for (const std::string& scheme : schemes_in(findings)) {
    std::vector<Real> sizes, numbers;
    Scope scope{.file = file, .constants = {}};
    for (const Finding& f : findings) {
      if (f.scheme != scheme || !concerns(order, f)) continue;
      scope.constants = f.constants;
      sizes.push_back(scope.evaluate({order.over, order.place}));
      numbers.push_back(order.differences ? f.value : error_of(f));
    }
    if (sizes.size() < (order.differences ? 3 : 2)) continue;
    result.push_back({.quantity = &order, .run = fmt::format("over {}", order.over), .scheme = scheme, .value = order.differences ? observed_order(sizes, numbers) : log_slope(sizes, numbers),
                      .reference = scope.evaluate_or(order.reference, nan), .tolerance = scope.evaluate_or(order.tolerance, nan),
                      .relative = scope.evaluate_or(order.relative, nan), .at_least = scope.evaluate_or(order.at_least, nan),
                      .at_most = scope.evaluate_or(order.at_most, nan), .constants = {}});
  }
  return result;
}

}  // namespace

Real log_slope(const std::vector<Real>& x, const std::vector<Real>& y)
{
  Real mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  const auto n = static_cast<Real>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) mean_x += std::log(x[k]) / n, mean_y += std::log(y[k]) / n;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += std::pow(std::log(x[k]) - mean_x, 2);
    xy += (std::log(x[k]) - mean_x) * (std::log(y[k]) - mean_y);
  }
  return xx > 0.0 ? xy / xx : nan;
}

Real observed_order(const std::vector<Real>& x, const std::vector<Real>& y)
{
  std::vector<std::pair<Real, Real>> runs;
  for (std::size_t k = 0; k < x.size(); ++k) runs.emplace_back(x[k], y[k]);
  std::sort(runs.begin(), runs.end());
  std::vector<Real> sizes, steps;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) sizes.push_back(runs[k].first), steps.push_back(std::abs(runs[k + 1].second - runs[k].second));
  return log_slope(sizes, steps);
}

std::vector<Row> judge(const std::string& case_name, const Expected& file, const std::vector<Solve>& solves, const std::vector<Solved>& solved)
{
  std::vector<Row> rows;
  std::vector<Finding> findings;
  for (std::size_t k = 0; k < solved.size(); ++k) {
    if (!solved[k].fault.empty()) rows.push_back(row_of_fault(case_name, solves[k], solved[k].fault));
    findings.insert(findings.end(), solved[k].findings.begin(), solved[k].findings.end());
  }
  for (const Quantity& q : file.quantities) {
    if (q.kind == QuantityKind::order)
      for (const Finding& f : orders(file, q, findings)) rows.push_back(to_row(case_name, f));
    for (const Finding& f : findings)
      if (f.quantity == &q) rows.push_back(to_row(case_name, f));
  }
  return rows;
}

}  // namespace terp
