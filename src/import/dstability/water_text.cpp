// D-Stability lets the pressure run linearly from the phreatic line, or the ground where that is lower, to the first
// reference line; Terp keeps the head of the phreatic line that far. A reference line with that head, along the ground
// or the phreatic line, makes both alike. Where reference lines cross the ground or each other, the lower one gives
// way.

#include "import/dstability/water_text.hpp"

#include "model/water/water_pressure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace terp {
namespace {

constexpr Real near_enough = 500.0;  // [Pa]: a tenth of what tells D-Stability results apart in a factor of safety

/// From left to right; empty if it goes back and forth.
std::vector<Vec<2>> left_to_right(const StixLine& line)
{
  std::vector<Vec<2>> places(line.begin(), line.end());
  if (!places.empty() && places.front()[0] > places.back()[0]) std::ranges::reverse(places);
  if (!std::ranges::is_sorted(places, {}, [](const Vec<2>& x) { return x[0]; })) return {};
  return places;
}

/// The line up to both ends of the section: beyond its own it is level, which is said where it slopes there.
std::vector<Vec<2>> to_both_ends(std::vector<Vec<2>> line, const SectionLayout& layout)
{
  if (line.size() < 2) return line;
  const Vec<2> first = line.front(), last = line.back();
  if (first[0] > layout.low[0] && line[1][1] != first[1]) line.insert(line.begin(), {layout.low[0], first[1]});
  if (last[0] < layout.high[0] && line.rbegin()[1][1] != last[1]) line.push_back({layout.high[0], last[1]});
  return line;
}

/// x of all corners that matter between the limits, and places between them.
std::vector<Real> stations(const StixSection& section, const SectionLayout& layout)
{
  std::set<Real> all;
  const Real left = layout.low[0], right = layout.high[0];
  const auto add = [&](Real x) { all.insert(std::clamp(x, left, right)); };
  for (const StixLayer& layer : section.stage().layers)
    for (const Vec<2>& x : layer.outline) add(x[0]);
  for (const StixLine& pit : section.stage().excavations)
    for (const Vec<2>& x : pit) add(x[0]);
  for (const StixHeadLine& head : section.stage().water.head_lines)
    for (const Vec<2>& x : head.line) add(x[0]);
  for (const StixReferenceLine& line : section.stage().water.reference_lines)
    for (const Vec<2>& x : line.line) add(x[0]);
  std::vector<Real> xs;
  for (const Real x : all)
    if (xs.empty() || x - xs.back() > 1e-3) xs.push_back(x);
  std::vector<Real> more;
  for (std::size_t k = 0; k + 1 < xs.size(); ++k) {
    const int n = std::max(1, static_cast<int>(std::ceil((xs[k + 1] - xs[k]) / (4.0 * layout.cell))));
    for (int i = 0; i < n; ++i) more.push_back(xs[k] + (xs[k + 1] - xs[k]) * i / n);
  }
  more.push_back(xs.back());
  return more;
}

/// The corners that keep a line within `tolerance` [m] of all of them, in height.
std::vector<Vec<2>> fewer(const std::vector<Vec<2>>& line, Real tolerance)
{
  if (line.size() < 3) return line;
  const Vec<2> a = line.front(), b = line.back();
  std::size_t worst = 0;
  Real most = tolerance;
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const Real along = b[0] > a[0] ? a[1] + (b[1] - a[1]) * (line[k][0] - a[0]) / (b[0] - a[0]) : 1e30;
    if (const Real off = std::abs(line[k][1] - along); off > most) most = off, worst = k;
  }
  if (worst == 0) return {a, b};
  const auto middle = line.begin() + static_cast<std::ptrdiff_t>(worst);
  std::vector<Vec<2>> kept = fewer({line.begin(), middle + 1}, tolerance);
  const std::vector<Vec<2>> rest = fewer({middle, line.end()}, tolerance);
  kept.insert(kept.end(), rest.begin() + 1, rest.end());
  return kept;
}

/// Where the water begins: the lower one of ground and phreatic line.
std::vector<Vec<2>> water_top(const StixSection& section, const std::vector<Real>& xs)
{
  std::vector<Vec<2>> top;
  for (const Real x : xs) {
    const StixColumn column = section.column(x);
    const Real ground = column.ground(), level = column.now().water().phreatic();
    if (!std::isfinite(level)) continue;
    top.push_back({x, std::round(1e3 * (std::isnan(ground) ? level : std::min(ground, level))) / 1e3});
  }
  return fewer(top, 0.02);
}

/// A line that stays 1 mm or more below another one, over the x of all corners of both.
std::vector<Vec<2>> held_below(const std::vector<Vec<2>>& line, const std::vector<Vec<2>>& upper)
{
  const Real apart = 1e-3;
  const auto gap = [&](Real x) { return elevation_at(upper, x) - apart - elevation_at(line, x); };
  std::set<Real> xs;
  for (const auto* corners : {&line, &upper})
    for (const Vec<2>& x : *corners) xs.insert(x[0]);
  if (std::ranges::all_of(xs, [&](Real x) { return gap(x) >= 0.0; })) return line;
  std::vector<Vec<2>> low;
  const auto add = [&](Real x) { low.push_back({x, elevation_at(line, x) + std::min(0.0, gap(x))}); };
  for (auto x = xs.begin(); x != xs.end(); ++x) {
    add(*x);
    const auto next = std::next(x);
    if (next != xs.end() && gap(*x) * gap(*next) < 0.0) add(*x + (*next - *x) * gap(*x) / (gap(*x) - gap(*next)));
  }
  for (Vec<2>& x : low)
    for (Real& coordinate : x) coordinate = std::round(1e6 * coordinate) / 1e6;
  return fewer(low, 0.2 * apart);
}

/// The water in the words of a case; no phreatic line: it cannot be said with lines.
WaterSituation as_lines(
    const StixSection& section, const SectionLayout& layout, const std::vector<Real>& xs, bool with_lines)
{
  const StixWater& water = section.stage().water;
  WaterSituation lines;
  if (water.is_mesh || !water.phreatic) return lines;
  const auto places_of = [&](const StixLine& line) { return to_both_ends(left_to_right(line), layout); };
  lines.phreatic_line = places_of(water.head_lines[*water.phreatic].line);
  if (lines.phreatic_line.empty() || (water.reference_lines.empty() && !with_lines)) return lines;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < water.head_lines.size(); ++k) {
    const std::string key = key_of_name(water.head_lines[k].label, "head");
    names.push_back(k == *water.phreatic ? std::string(phreatic_head) : fmt::format("{}_{}", key, k + 1));
    if (k == *water.phreatic) continue;
    lines.head_lines.push_back({names.back(), places_of(water.head_lines[k].line)});
    if (lines.head_lines.back().places.empty()) return {};
  }
  std::vector<const StixReferenceLine*> order;
  for (const StixReferenceLine& line : water.reference_lines) order.push_back(&line);
  const Real middle = 0.5 * (xs.front() + xs.back());
  std::ranges::stable_sort(order, std::greater{}, [&](const StixReferenceLine* line) {
    const auto places = left_to_right(line->line);
    return places.empty() ? 0.0 : elevation_at(places, middle);
  });
  lines.reference_lines.push_back({water_top(section, xs), std::string(phreatic_head), std::string(phreatic_head)});
  for (const StixReferenceLine* line : order) {
    const auto places = places_of(line->line);
    if (places.empty()) return {};
    lines.reference_lines.push_back(
        {held_below(places, lines.reference_lines.back().places), names[line->top_head], names[line->bottom_head]});
  }
  return lines;
}

/// Heights of a column at which pressures are compared and given.
std::vector<Real> heights(const SectionLayout& layout, Real step)
{
  std::vector<Real> all;
  const auto n = static_cast<int>(std::ceil((layout.top + 2.0 * layout.cell - layout.low[1]) / step));
  for (int k = 0; k <= n; ++k) all.push_back(layout.low[1] + step * k);
  return all;
}

Real largest_deviation(const StixSection& section, const SectionLayout& layout, const WaterSituation& lines)
{
  WaterCase water;
  water.unit_weight = section.stage().water.unit_weight;
  Real most = 0.0;
  for (Real x = layout.low[0] + 0.5 * layout.cell; x < layout.high[0]; x += layout.cell) {
    const StixColumn column = section.column(x);
    for (const Real z : heights(layout, layout.cell)) {
      if (!(z < column.ground())) continue;
      const Real cap = column.now().total_stress(z);
      const Real stored = std::min(cap, column.now().water().pressure(z));
      most = std::max(most, std::abs(std::min(cap, water_pressure(water, lines, {x, z}, 0.0)) - stored));
    }
  }
  return most;
}

std::string grid_text(const StixSection& section, const SectionLayout& layout)
{
  std::string text = "x,y,value\n";
  const auto columns = static_cast<int>(std::ceil((layout.high[0] - layout.low[0]) / layout.cell));
  for (int k = 0; k <= columns; ++k) {
    const Real x = std::min(layout.low[0] + k * layout.cell, layout.high[0]);
    const StixColumn column = section.column(x);
    for (const Real z : heights(layout, 0.5 * layout.cell))
      text += fmt::format("{},{},{:.1f}\n", number_text(x), number_text(z), column.now().water().pressure(z));
  }
  return text;
}

std::string reference_text(const WaterSituation& lines)
{
  std::string text = "[";
  for (const ReferenceLine& line : lines.reference_lines) {
    const std::string heads = line.head == line.head_bottom ? fmt::format("head = {}", in_quotes(line.head))
                                                            : fmt::format("head_top = {}, head_bottom = {}",
                                                                  in_quotes(line.head), in_quotes(line.head_bottom));
    text +=
        fmt::format("{}\n  {{ line = {}, {} }}", text.size() > 1 ? "," : "", places_text(line.places, 4, 11), heads);
  }
  return text + "]";
}

}  // namespace

WaterText water_below(const SectionLayout& layout)
{
  const Real level = layout.low[1] - 1.0;
  WaterText text;
  text.lines.push_back({"phreatic_line", places_text({{layout.low[0], level}, {layout.high[0], level}}, 2, 16),
      "below the section: this stage has no water"});
  return text;
}

WaterText water_text(const StixSection& section, const SectionLayout& layout, const std::string& name, bool with_lines)
{
  WaterText text;
  const StixWater& water = section.stage().water;
  if (!water.is_mesh && !water.phreatic) return text;
  const std::vector<Real> xs = stations(section, layout);
  const WaterSituation lines = as_lines(section, layout, xs, with_lines);
  if (!lines.phreatic_line.empty()) text.deviation = largest_deviation(section, layout, lines);
  text.on_grid = lines.phreatic_line.empty() || text.deviation > near_enough;
  if (text.on_grid) {
    text.deviation = 0.0;
    text.grid_file = name + ".csv";
    text.grid = grid_text(section, layout);
    text.lines.push_back({"pressure", fmt::format("{{ csv = {} }}", in_quotes(text.grid_file)),
        "the pore pressure of the file on a grid, in Pa: its water cannot be said with lines"});
    for (const Real x : xs)
      if (const Real level = section.column(x).now().water().phreatic(); std::isfinite(level))
        text.phreatic.push_back({x, level});
    return text;
  }
  text.phreatic = lines.phreatic_line;
  text.lines.push_back({"phreatic_line", places_text(lines.phreatic_line, 2, 16),
      fmt::format("head line {}", in_quotes(water.head_lines[*water.phreatic].label))});
  if (lines.reference_lines.empty()) return text;
  if (!lines.head_lines.empty()) {
    std::string heads;
    for (const HeadLine& head : lines.head_lines)
      heads += fmt::format("{} {} = {}", heads.empty() ? "" : ",", head.name, places_text(head.places, 4, 30));
    text.lines.push_back({"head_lines", "{" + heads + " }", ""});
  }
  text.lines.push_back({"reference_lines", reference_text(lines),
      "the first one lies on the ground or the phreatic line: from there the pressure is linear to the next"});
  return text;
}

}  // namespace terp
