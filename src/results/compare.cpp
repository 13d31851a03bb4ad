#include "results/compare.hpp"

#include "schemes/scheme.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Value = std::optional<Real>;

constexpr Real round_off = 1e-9;  // of a strength, relative [-]

Value finite(Real value) { return std::isfinite(value) ? Value(value) : std::nullopt; }

Value end_time(const RunResults& run)
{
  const auto* time = run.ledger.find("time");
  return time != nullptr && !time->empty() ? finite(time->back()) : std::nullopt;
}

/// Share of the volume whose strength is below half of its peak, at a time [%].
Value softened_at(const RunResults& run, Real time)
{
  for (const auto& [t, fraction] : run.summary.values.softened_fraction)
    if (std::abs(t - time) <= same_time) return 100.0 * fraction;
  return std::nullopt;
}

/// The slides that the summary tells of: none while it is behind.
std::vector<SlideSummary> slides_in(const RunResults& run)
{
  return summary_is_behind(run) ? std::vector<SlideSummary>{} : run.summary.values.slides;
}

Value slide_begins(const RunResults& run, std::size_t k)
{
  const auto slides = slides_in(run);
  return k < slides.size() ? Value(slides[k].slide.begins) : std::nullopt;
}

Value slide_stops(const RunResults& run, std::size_t k)
{
  const auto slides = slides_in(run);
  return k < slides.size() ? slides[k].slide.stops : std::nullopt;
}

struct RowMaker {
  const std::vector<RunResults>& runs;
  Comparison& comparison;

  void add(std::string label, std::string unit, int digits, const std::function<Value(const RunResults&)>& value) const
  {
    ComparisonRow row{.label = std::move(label), .unit = std::move(unit), .values = {}, .digits = digits};
    for (const RunResults& run : runs) row.values.push_back(value(run));
    comparison.rows.push_back(std::move(row));
  }
  /// A number of the summary, with the label and the unit of its table; none while the summary is behind.
  void add(std::string_view name, int digits) const
  {
    const SummaryQuantity& quantity = *find_summary_quantity(name);
    add(std::string(quantity.info.label), std::string(quantity.info.unit), digits, number_of(quantity, 1.0));
  }
  /// The same, times a factor and in a unit of its own.
  void add(std::string_view name, std::string unit, int digits, Real factor) const
  {
    const SummaryQuantity& quantity = *find_summary_quantity(name);
    add(std::string(quantity.info.label), std::move(unit), digits, number_of(quantity, factor));
  }

 private:
  static std::function<Value(const RunResults&)> number_of(const SummaryQuantity& quantity, Real factor)
  {
    return [&quantity, factor](const RunResults& run) -> Value {
      if (summary_is_behind(run)) return std::nullopt;
      const Value value = quantity.number(run.summary.values);
      return value ? Value(factor * *value) : std::nullopt;
    };
  }
};

void add_motion(const RowMaker& table)
{
  table.add("time at the end", "s", 3, end_time);
  table.add("front_x", 2);
  table.add("run_out", 2);
  table.add("crest_x", 2);
  table.add("crest_y", 2);
  table.add("first slide begins", "s", 2, [](const RunResults& run) { return slide_begins(run, 0); });
  table.add("first slide stops", "s", 2, [](const RunResults& run) { return slide_stops(run, 0); });
  table.add("second slide begins", "s", 2, [](const RunResults& run) { return slide_begins(run, 1); });
  table.add("second slide stops", "s", 2, [](const RunResults& run) { return slide_stops(run, 1); });
  table.add("moved_volume", 2);
  table.add("moved_fraction", "%", 1, 100.0);
  table.add("intact_fraction", "%", 1, 100.0);
  table.add("max_eps_eq_p", 2);
}

void add_softening(const RowMaker& table)
{
  Real end = std::numeric_limits<Real>::infinity();
  for (const RunResults& run : table.runs) end = std::min(end, end_time(run).value_or(0.0));
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const Real time = end * quarter / 4.0;
    table.add(fmt::format("softened volume at {:.3g} s", time), "%", 1,
        [=](const RunResults& run) { return softened_at(run, time); });
  }
}

std::vector<std::string> named_points(const std::vector<RunResults>& runs)
{
  std::vector<std::string> names;
  for (const RunResults& run : runs)
    for (const PointTable& point : run.history)
      if (std::ranges::find(names, point.point) == names.end()) names.push_back(point.point);
  return names;
}

void add_audit(const RowMaker& table)
{
  table.add("named points whose S_u ever rose", "-", 0, [](const RunResults& run) -> Value {
    return run.history.empty() ? std::nullopt : Value(static_cast<Real>(points_that_regained_strength(run).size()));
  });
  table.add("points_eps_eq_p_fell", 0);
  table.add("points_su_rose", 0);
  table.add("clamped_points", 0);
  table.add("energy_balance_error", "%", 2, 100.0);
  table.add("v_999", 2);
}

/// Largest or last entry of a column of the ledger.
Value largest_in(const RunResults& run, std::string_view column)
{
  const auto* values = run.ledger.find(column);
  return values != nullptr && !values->empty() ? finite(*std::max_element(values->begin(), values->end()))
                                               : std::nullopt;
}
Value last_in(const RunResults& run, std::string_view column)
{
  const auto* values = run.ledger.find(column);
  return values != nullptr && !values->empty() ? finite(values->back()) : std::nullopt;
}

void add_energies(const RowMaker& table)
{
  const auto in_kilojoule = [](Value energy) { return energy ? Value(1e-3 * *energy) : std::nullopt; };
  const auto add = [&](std::string label, auto of, std::string_view column) {
    table.add(std::move(label), "kJ/m", 1, [=](const RunResults& run) { return in_kilojoule(of(run, column)); });
  };
  add("largest kinetic energy", largest_in, "kinetic");
  add("work of gravity", last_in, "gravity_work");
  add("plastic dissipation", last_in, "plastic");
  add("work of damping", last_in, "damping_work");
  add("work at the sides", last_in, "boundary_work");
}

void add_cost(const RowMaker& table)
{
  table.add("points", 0);
  table.add("steps", 0);
  table.add("threads", 0);
  table.add("point_steps_per_s", "10^6/s", 2, 1e-6);
  table.add("wall_s", 1);
}

std::string cell_text(Value value, int digits)
{
  return value ? fmt::format("{:.{}f}", *value, digits) : std::string("-");
}

/// What a row of softening times says: the strain, if it is that of all runs in which anything softens.
std::string softening_label(const std::vector<RunResults>& runs)
{
  std::vector<Real> strains;
  for (const RunResults& run : runs)
    if (run.summary.values.softened_strain) strains.push_back(*run.summary.values.softened_strain);
  const bool same = !strains.empty() && std::ranges::count(strains, strains[0]) == std::ssize(strains);
  return same ? fmt::format(": eps_eq_p > {:g} from", strains[0]) : ": 95 % softened from";
}

}  // namespace

std::string scheme_title(std::string_view scheme)
{
  const Scheme* known = find_scheme(scheme);
  return std::string(known == nullptr ? scheme : known->title);
}

std::vector<std::string> points_that_regained_strength(const RunResults& run)
{
  std::vector<std::string> names;
  for (const PointTable& history : run.history) {
    const auto* su = history.table.find("su");
    if (su == nullptr) continue;
    const auto rises = [](Real before, Real after) { return after > before * (1.0 + round_off); };
    if (std::adjacent_find(su->begin(), su->end(), rises) != su->end()) names.push_back(history.point);
  }
  return names;
}

std::optional<Real> softening_time(const RunResults& run, std::string_view point)
{
  const std::optional<Real> softened = run.summary.values.softened_strain;
  for (const PointTable& history : run.history) {
    if (!softened) break;
    const auto *time = history.table.find("time"), *strain = history.table.find("eps_eq_p");
    if (history.point != point || time == nullptr || strain == nullptr) continue;
    for (std::size_t k = 0; k < time->size(); ++k)
      if ((*strain)[k] > *softened) return (*time)[k];
  }
  return std::nullopt;
}

Comparison compare_runs(const std::vector<RunResults>& runs, const std::vector<std::string>& names)
{
  Comparison comparison{.names = names, .schemes = {}, .rows = {}, .text = {}};
  for (const RunResults& run : runs) comparison.schemes.push_back(run.summary.values.scheme);
  const RowMaker table{runs, comparison};
  add_motion(table);
  add_softening(table);
  const std::string softens = softening_label(runs);
  for (const std::string& point : named_points(runs))
    table.add(point + softens, "s", 2, [&](const RunResults& run) { return softening_time(run, point); });
  add_audit(table);
  add_energies(table);
  add_cost(table);
  comparison.text = describe_differences(runs, comparison);
  return comparison;
}

std::string comparison_table(const Comparison& comparison)
{
  std::vector<std::vector<std::string>> lines{{""}, {"scheme"}};
  for (std::size_t k = 0; k < comparison.names.size(); ++k) {
    lines[0].push_back(comparison.names[k]);
    lines[1].push_back(comparison.schemes[k]);
  }
  for (const ComparisonRow& row : comparison.rows) {
    lines.push_back({row.unit == "-" ? row.label : fmt::format("{} [{}]", row.label, row.unit)});
    for (const Value& value : row.values) lines.back().push_back(cell_text(value, row.digits));
  }
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const auto& line : lines)
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
  std::string text;
  for (const auto& line : lines) {
    text += fmt::format("{:<{}}", line[0], widths[0]);
    for (std::size_t c = 1; c < line.size(); ++c) text += fmt::format("   {:>{}}", line[c], widths[c]);
    text += '\n';
  }
  text += '\n';
  for (const auto& sentence : comparison.text) text += sentence + '\n';
  return text;
}

std::string comparison_json(const Comparison& comparison)
{
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const ComparisonRow& row : comparison.rows) {
    Json values = Json::array();
    for (const Value& value : row.values) values.push_back(value ? Json(*value) : Json());
    rows.push_back({{"label", row.label}, {"unit", row.unit}, {"digits", row.digits}, {"values", std::move(values)}});
  }
  const Json json{{"columns", comparison.names}, {"schemes", comparison.schemes}, {"rows", std::move(rows)},
      {"text", comparison.text}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace terp
