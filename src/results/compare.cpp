#include "results/compare.hpp"

#include "output/json_text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

namespace terp {
namespace {

using Value = std::optional<Real>;

constexpr Real softened_strain = 0.06;  // eps_eq_p at which 95 % of the strength drop is reached with the paper's eta = 50 [-]
constexpr Real same_time = 0.02;        // a frame this near to a time counts as of that time [s]

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

Value slide_begins(const RunResults& run, std::size_t k)
{
  const auto& slides = run.summary.values.slides;
  return k < slides.size() ? Value(slides[k].slide.begins) : std::nullopt;
}

Value slide_stops(const RunResults& run, std::size_t k)
{
  const auto& slides = run.summary.values.slides;
  return k < slides.size() ? slides[k].slide.stops : std::nullopt;
}

/// Makes the rows of a table.
struct RowMaker {
  const std::vector<RunResults>& runs;
  Comparison& comparison;

  void add(std::string label, std::string unit, int digits, const std::function<Value(const RunResults&)>& value) const
  {
    ComparisonRow row{.label = std::move(label), .unit = std::move(unit), .values = {}, .digits = digits};
    for (const RunResults& run : runs) row.values.push_back(value(run));
    comparison.rows.push_back(std::move(row));
  }
  /// A number of the summary.
  template <class T>
  void add(std::string label, std::string unit, int digits, T Summary::* member, Real factor = 1.0) const
  {
    add(std::move(label), std::move(unit), digits, [=](const RunResults& run) -> Value {
      const Value value = Value(run.summary.values.*member);
      return value ? finite(factor * *value) : std::nullopt;
    });
  }
};

void add_motion(const RowMaker& table)
{
  table.add("time at the end", "s", 3, end_time);
  table.add("front at the end", "m", 2, &Summary::front_x);
  table.add("run-out of the front", "m", 2, &Summary::run_out);
  table.add("crest at the end", "m", 2, &Summary::crest_x);
  table.add("first slide begins", "s", 2, [](const RunResults& run) { return slide_begins(run, 0); });
  table.add("first slide stops", "s", 2, [](const RunResults& run) { return slide_stops(run, 0); });
  table.add("second slide begins", "s", 2, [](const RunResults& run) { return slide_begins(run, 1); });
  table.add("volume that moved", "m^2", 2, &Summary::moved_volume);
  table.add("share that moved", "%", 1, &Summary::moved_fraction, 100.0);
  table.add("largest eps_eq_p at the end", "-", 2, &Summary::max_eps_eq_p);
}

void add_softening(const RowMaker& table)
{
  Real end = std::numeric_limits<Real>::infinity();
  for (const RunResults& run : table.runs) end = std::min(end, end_time(run).value_or(0.0));
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const Real time = end * quarter / 4.0;
    table.add(fmt::format("softened volume at {:.3g} s", time), "%", 1, [=](const RunResults& run) { return softened_at(run, time); });
  }
}

/// Names of the points of any run, in their order.
std::vector<std::string> named_points(const std::vector<RunResults>& runs)
{
  std::vector<std::string> names;
  for (const RunResults& run : runs)
    for (const PointTable& point : run.history)
      if (std::find(names.begin(), names.end(), point.point) == names.end()) names.push_back(point.point);
  return names;
}

void add_audit(const RowMaker& table)
{
  table.add("points whose eps_eq_p ever fell", "-", 0, &Summary::points_eps_eq_p_fell);
  table.add("points whose S_u ever rose", "-", 0, &Summary::points_su_rose);
  table.add("points put back at a wall", "-", 0, &Summary::clamped_points);
  table.add("energy balance error", "%", 2, &Summary::energy_balance_error, 100.0);
  table.add("speed, largest 99.9 % quantile", "m/s", 2, &Summary::v_999);
}

void add_cost(const RowMaker& table)
{
  table.add("material points", "-", 0, &Summary::n_points);
  table.add("steps", "-", 0, &Summary::n_steps);
  table.add("threads", "-", 0, &Summary::threads);
  table.add("million point-steps per second", "1/s", 2, &Summary::point_steps_per_s, 1e-6);
  table.add("wall time", "s", 1, &Summary::wall_s);
}

/// What distinguishes two runs: the scheme if it does, else the names.
struct Pair {
  std::string a, b;
};

Pair titles(const Comparison& c, std::size_t other)
{
  if (c.schemes[0] != c.schemes[other]) return {scheme_title(c.schemes[0]), scheme_title(c.schemes[other])};
  return {c.names[0], c.names[other]};
}

const ComparisonRow& row_of(const Comparison& c, std::string_view label)
{
  return *std::find_if(c.rows.begin(), c.rows.end(), [&](const ComparisonRow& row) { return row.label == label; });
}

/// True if all runs end at one time, as far as that is known.
bool end_together(const Comparison& c)
{
  const auto& ends = row_of(c, "time at the end").values;
  return std::all_of(ends.begin(), ends.end(), [&](Value end) { return !end || !ends[0] || std::abs(*end - *ends[0]) <= same_time; });
}

/// What must be known before the numbers of two runs are set against each other; empty if all is well.
std::string end_sentence(const Comparison& c, std::size_t other)
{
  const auto& ends = row_of(c, "time at the end").values;
  if (!ends[0] || !ends[other] || std::abs(*ends[0] - *ends[other]) <= same_time) return "";
  return fmt::format("The runs end at different times, {} at {:.2f} s and {} at {:.2f} s: what they say of the end is not of one time.", c.names[0], *ends[0],
                     c.names[other], *ends[other]);
}

/// One sentence on how far the runs went.
std::string front_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const auto& front = row_of(c, "front at the end").values;
  if (!front[0] || !front[other]) return "The front of one run is not known.";
  const Real more = *front[0] - *front[other];
  if (std::abs(more) < 0.005) return fmt::format("The fronts end at the same place, {:.2f} m.", *front[0]);
  return fmt::format("With {} the front ends {:.2f} m {} than with {} ({:.2f} m against {:.2f} m).", who.a, std::abs(more), more > 0.0 ? "farther" : "nearer", who.b,
                     *front[0], *front[other]);
}

/// "at 0.18 s with A, at 0.25 s with B" or "... with A; with B there is none".
std::string times_of_slide(const std::vector<Value>& begins, std::size_t other, const Pair& who)
{
  const auto at = [](Value time, const std::string& name) { return fmt::format("at {:.2f} s with {}", *time, name); };
  if (begins[0] && begins[other]) return at(begins[0], who.a) + ", " + at(begins[other], who.b);
  return begins[0] ? fmt::format("{}; with {} there is none", at(begins[0], who.a), who.b) : fmt::format("{}; with {} there is none", at(begins[other], who.b), who.a);
}

std::string slides_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const auto& first = row_of(c, "first slide begins").values;
  const auto& second = row_of(c, "second slide begins").values;
  if (!first[0] && !first[other]) return "Neither run has a slide.";
  std::string text = "The first slide begins " + times_of_slide(first, other, who) + ".";
  if (second[0] || second[other]) text += " A second begins " + times_of_slide(second, other, who) + ".";
  return text;
}

std::string softening_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const ComparisonRow* last = nullptr;
  for (const ComparisonRow& row : c.rows)
    if (row.label.starts_with("softened volume")) last = &row;
  if (last == nullptr || !last->values[0] || !last->values[other]) return "";
  const std::string when = end_together(c) ? "At the end" : "At" + last->label.substr(last->label.rfind(" at ") + 3);
  return fmt::format("{} {:.1f} % of the soil has lost more than half of its strength with {}, {:.1f} % with {}.", when, *last->values[0], who.a, *last->values[other],
                     who.b);
}

std::string audit_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const auto& fell = row_of(c, "points whose eps_eq_p ever fell").values;
  const auto& n = row_of(c, "material points").values;
  const auto clause = [&](std::size_t k, const std::string& name) {
    if (!fell[k] || *fell[k] == 0.0) return fmt::format("with {} no point loses any of its plastic strain", name);
    return fmt::format("with {} the plastic strain fell at {:.0f} of {:.0f} points, so that soil regained strength, which its law forbids", name, *fell[k], n[k].value_or(0.0));
  };
  std::string text = clause(0, who.a) + "; " + clause(other, who.b) + ".";
  text[0] = 'W';
  return text;
}

void add_text(const std::vector<RunResults>& runs, Comparison& c)
{
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (summary_is_behind(runs[k])) c.text.push_back(fmt::format("{} has not ended; what its summary holds is older than its ledger and is not compared in words.", c.names[k]));
  for (std::size_t other = 1; other < c.names.size(); ++other) {
    if (summary_is_behind(runs[0]) || summary_is_behind(runs[other])) continue;
    const Pair who = titles(c, other);
    for (const auto& sentence : {end_sentence(c, other), slides_sentence(c, other, who), front_sentence(c, other, who), softening_sentence(c, other, who), audit_sentence(c, other, who)})
      if (!sentence.empty()) c.text.push_back(sentence);
  }
}

std::string cell_text(Value value, int digits) { return value ? fmt::format("{:.{}f}", *value, digits) : std::string("-"); }

}  // namespace

std::string scheme_title(std::string_view scheme)
{
  if (scheme == "mpm_mixed") return "MPM-Mixed";
  if (scheme == "mpm_gp") return "MPM-GP";
  return scheme == "standard_mpm" ? "standard MPM" : std::string(scheme);
}

std::optional<Real> softening_time(const RunResults& run, std::string_view point)
{
  for (const PointTable& history : run.history) {
    const auto *time = history.table.find("time"), *strain = history.table.find("eps_eq_p");
    if (history.point != point || time == nullptr || strain == nullptr) continue;
    for (std::size_t k = 0; k < time->size(); ++k)
      if ((*strain)[k] > softened_strain) return (*time)[k];
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
  for (const std::string& point : named_points(runs))
    table.add(point + ": eps_eq_p > 0.06 from", "s", 2, [&](const RunResults& run) { return softening_time(run, point); });
  add_audit(table);
  add_cost(table);
  add_text(runs, comparison);
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
  JsonText json;
  json.begin_object().key("columns").begin_array();
  for (const auto& name : comparison.names) json.value(name);
  json.end_array().key("schemes").begin_array();
  for (const auto& scheme : comparison.schemes) json.value(scheme);
  json.end_array().key("rows").begin_array();
  for (const ComparisonRow& row : comparison.rows) {
    json.begin_object().entry("label", row.label).entry("unit", row.unit).entry("digits", row.digits).key("values").begin_array();
    for (const Value& value : row.values) json.value(value);
    json.end_array().end_object();
  }
  json.end_array().key("text").begin_array();
  for (const auto& sentence : comparison.text) json.value(sentence);
  json.end_array().end_object();
  return json.text();
}

}  // namespace terp
