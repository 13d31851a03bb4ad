#include "model/water/level_series.hpp"

#include "model/bodies/body_outline.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real hour = 3600.0;           // [s]
constexpr int samples = 800;            // of the ground
constexpr Real least_over_land = 0.05;  // of the height of the crest: ground below it is land

struct GroundPlace {
  Real x, y;
};

/// The highest soil over x, from the river's side on; empty: a body has no outline.
std::vector<GroundPlace> ground_of_bodies(const Case& c, bool from_left)
{
  std::vector<std::vector<Side>> bodies;
  Real left = std::numeric_limits<Real>::infinity(), right = -left;
  for (const BodyCase& body : c.bodies) {
    if (body.polygon.empty()) return {};
    if (body.placed > 0) continue;
    std::vector<Side>& sides = bodies.emplace_back();
    for (std::size_t k = 0; k < body.polygon.size(); ++k) {
      sides.push_back({body.polygon[k], body.polygon[(k + 1) % body.polygon.size()]});
      left = std::min(left, body.polygon[k][0]), right = std::max(right, body.polygon[k][0]);
    }
  }
  std::vector<GroundPlace> ground;
  for (int k = 0; k < samples; ++k) {
    const Real share = (k + 0.5) / samples, x = std::lerp(left, right, from_left ? share : 1.0 - share);
    Real highest = -std::numeric_limits<Real>::infinity();
    for (const std::vector<Side>& sides : bodies)
      for (const Real y : crossings_of_vertical(sides, x)) highest = std::max(highest, y);
    if (std::isfinite(highest)) ground.push_back({x, highest});
  }
  return ground;
}

}  // namespace

std::string describe(const LevelSeries& series)
{
  const auto highest = std::ranges::max_element(series.levels);
  const auto at = static_cast<std::size_t>(highest - series.levels.begin());
  const Real begin = series.times.front();
  return fmt::format("{} levels in {:.4g} h, from {:.3f} m to {:.3f} m at {:.4g} h; 1 h takes {:.4g} s",
      series.levels.size(), (series.times.back() - begin) / hour, series.levels.front(), *highest,
      (series.times[at] - begin) / hour, hour / series.shorten);
}

std::vector<Vec<2>> line_of_level(const Case& c, Real level, RiverSide side)
{
  const bool from_left = side != RiverSide::right;
  const std::vector<GroundPlace> ground = ground_of_bodies(c, from_left);
  if (ground.empty()) return {};
  const auto crest = std::ranges::max_element(ground, {}, &GroundPlace::y);
  const Real land = ground.back().y, beyond = std::min(land, level);
  const auto toe = std::find_if(crest, ground.end(),
      [&](const GroundPlace& place) { return place.y <= land + least_over_land * (crest->y - land); });
  const auto meets = std::find_if(ground.begin(), crest, [&](const GroundPlace& p) { return p.y >= level; });
  std::vector<Vec<2>> line{{ground.front().x, level}};
  if (meets != ground.begin()) line.push_back({meets->x, level});
  if (toe != ground.end()) line.push_back({toe->x, beyond});
  line.push_back({ground.back().x, beyond});
  if (!from_left) std::ranges::reverse(line);
  return line;
}

bool follow_series(Case& c)
{
  if (!c.water.series) return true;
  const LevelSeries& series = *c.water.series;
  const auto situation_at = [&](Real level) {
    WaterSituation situation = c.water.start;
    if (c.water.kind == WaterKind::seepage) {
      situation.seepage.river =
          RiverCase{series.side == RiverSide::right ? SectionSide::right : SectionSide::left, level};
      return situation;
    }
    situation.phreatic_line.clear();
    for (const auto& place : series.line) situation.phreatic_line.push_back({place[0](level), place[1](level)});
    if (series.line.empty()) situation.phreatic_line = line_of_level(c, level, series.side);
    return situation;
  };
  std::vector<WaterSituation> situations;
  for (std::size_t k = 0; k < series.times.size(); ++k) {
    situations.push_back(situation_at(series.levels[k]));
    if (c.water.kind == WaterKind::lines && situations.back().phreatic_line.empty()) return false;
    situations.back().time = (series.times[k] - series.times.front()) / series.shorten;
  }
  c.water.start = situations.front();
  c.water.start.time = std::numeric_limits<Real>::quiet_NaN();
  c.water.situations.insert(c.water.situations.end(), situations.begin() + 1, situations.end());
  return true;
}

}  // namespace terp
