// At one x the reference lines become levels, from top to bottom. A place lies between the last level above it and the
// first at or below it. So the height between these two is never zero. A line without a head takes that of the phreatic
// line. The first knot is always at t = 0, and way_at relies on it.

#include "model/water/water_pressure.hpp"

#include "math/interpolate.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

Real elevation_at(std::span<const Vec<2>> line, Real x) { return interpolate(line, x); }

WaterColumn::WaterColumn(const WaterSituation& situation, Real x) : phreatic_(elevation_at(situation.phreatic_line, x))
{
  const auto head_of = [&](const std::string& name) {
    const auto found = std::ranges::find(situation.head_lines, name, &HeadLine::name);
    return found == situation.head_lines.end() ? Head{0.0, 1.0} : Head{elevation_at(found->places, x), 0.0};
  };
  levels_.reserve(situation.reference_lines.size());
  for (const ReferenceLine& line : situation.reference_lines) {
    const Real y = elevation_at(line.places, x);
    const auto place = std::ranges::upper_bound(levels_, y, std::ranges::greater{}, &Level::y);
    levels_.insert(place, {y, head_of(line.head), head_of(line.head_bottom)});
  }
}

Real WaterColumn::head(Real y) const
{
  if (levels_.empty() || y >= phreatic_ || y >= levels_.front().y) return phreatic_;
  const auto [above, below] = levels_about(y);
  const Real upper = above->head_bottom.at(phreatic_);
  if (below == levels_.end()) return upper;
  return std::lerp(upper, below->head.at(phreatic_), (above->y - y) / (above->y - below->y));
}

Head WaterColumn::head_with_table(Real y) const
{
  if (levels_.empty() || y >= levels_.front().y) return {0.0, 1.0};
  const auto [above, below] = levels_about(y);
  const Head& upper = above->head_bottom;
  if (below == levels_.end()) return upper;
  const Real part = (above->y - y) / (above->y - below->y);
  return {std::lerp(upper.own, below->head.own, part), std::lerp(upper.of_table, below->head.of_table, part)};
}

std::array<std::vector<WaterColumn::Level>::const_iterator, 2> WaterColumn::levels_about(Real y) const
{
  const auto below = std::ranges::find_if(levels_, [y](const Level& level) { return level.y <= y; });
  return {below - 1, below};
}

Real unlimited_pressure(const WaterCase& water, const WaterSituation& situation, Vec<2> x, Real time)
{
  if (situation.formula && !situation.formula_gives_head) return situation.formula(x, time);
  if (situation.formula) return water.unit_weight * (situation.formula(x, time) - x[1]);
  return water.unit_weight * (WaterColumn(situation, x[0]).head(x[1]) - x[1]);
}

Real water_pressure(const WaterCase& water, const WaterSituation& situation, Vec<2> x, Real time)
{
  return std::max(unlimited_pressure(water, situation, x, time), 0.0);
}

Real level_at(Real x, Real ground, const WaterCase& water, const WaterSituation& situation)
{
  if (!situation.phreatic_line.empty()) return elevation_at(situation.phreatic_line, x);
  return ground + unlimited_pressure(water, situation, {x, ground}, 0.0) / water.unit_weight;
}

namespace {

/// Elevation of the highest water along a vertical line in which pressure grows as in still water; none: `low`. A grid
/// blurs where its pressure begins, so the head a little below counts.
Real highest_water(const WaterCase& water, const WaterSituation& situation, Real x, Real low, Real high)
{
  constexpr int n = 200, below = 5;
  const Real step = (high - low) / n;
  const auto head = [&](Real y) { return y + water_pressure(water, situation, {x, y}, 0.0) / water.unit_weight; };
  if (const Real top = head(high); top > high) return top;
  for (int k = 1; k <= n; ++k)
    if (const Real y = high - k * step; head(y) > y)
      return std::clamp(head(std::max(y - below * step, low)), std::max(y - below * step, low), y + step);
  return low;
}

}  // namespace

std::vector<Vec<2>> water_table(const WaterCase& water, const WaterSituation& situation, Vec<2> low, Vec<2> high)
{
  if (!situation.phreatic_line.empty() || !situation.formula) return situation.phreatic_line;
  if (situation.formula_changes) return {};
  constexpr int n = 200;
  std::vector<Vec<2>> line;
  for (int k = 0; k <= n; ++k) {
    const Real x = std::lerp(low[0], high[0], static_cast<Real>(k) / n);
    line.push_back({x, highest_water(water, situation, x, low[1], high[1])});
  }
  const bool is_dry = std::ranges::all_of(line, [&](const Vec<2>& place) { return place[1] <= low[1]; });
  return is_dry ? std::vector<Vec<2>>{} : line;
}

std::vector<WaterKnot> knots_of(const WaterCase& water)
{
  if (water.standing) return {{0.0, *water.standing}};
  std::vector<WaterKnot> knots{{0.0, 0}};
  for (std::size_t k = 0; k < water.situations.size(); ++k)
    if (const Real time = water.situations[k].time; !std::isnan(time)) knots.push_back({time, k + 1});
  std::ranges::stable_sort(knots, {}, &WaterKnot::time);
  return knots;
}

WaterWay way_at(std::span<const WaterKnot> knots, Real time)
{
  const auto after = std::ranges::find_if(knots, [time](const WaterKnot& knot) { return knot.time > time; });
  const WaterKnot& a = *(after - 1);
  const WaterKnot& b = after == knots.end() ? a : *after;
  return {a.situation, b.situation, b.time > a.time ? (time - a.time) / (b.time - a.time) : 0.0};
}

std::size_t situation_number(const WaterCase& water, std::string_view name)
{
  const auto found = std::ranges::find(water.situations, name, &WaterSituation::name);
  return name.empty() || found == water.situations.end()
             ? 0
             : static_cast<std::size_t>(found - water.situations.begin()) + 1;
}

}  // namespace terp
