#include "simulation/flood_level.hpp"

#include "simulation/ground_section.hpp"
#include "simulation/overburden.hpp"
#include "simulation/stages.hpp"
#include "water/water_pressure.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real least_depth = 1e-6;  // of water that counts as free [m]
constexpr Real no_water = -std::numeric_limits<Real>::infinity();

/// The start, the water of each stage or each time of a situation, and the end of the run.
std::vector<WaterWay> waters_of(const Case& c)
{
  std::vector<WaterWay> waters{{0, 0, 0.0}};
  for (std::size_t k = 0; k < c.stages.size(); ++k)
    if (const StageWater water = water_of_stage(c, k); water.given) waters.push_back({water.to, water.to, 0.0});
  const std::vector<WaterKnot> knots = knots_of(c.water);
  for (std::size_t k = 1; k < knots.size() && knots[k - 1].time < c.time.end; ++k) {
    const Real length = knots[k].time - knots[k - 1].time;
    const Real share = length > 0.0 ? std::min((c.time.end - knots[k - 1].time) / length, Real(1.0)) : 1.0;
    waters.push_back({knots[k - 1].situation, knots[k].situation, share});
  }
  return waters;
}

/// The free water at an end of the section, and the situation in which it stands highest.
struct FreeWater {
  Real level = no_water;  ///< [m]
  std::string situation = {};
};

/// x: where the soil ends [m].
FreeWater highest_at(Real x, Real ground, const Case& c)
{
  FreeWater highest;
  for (const WaterWay& water : waters_of(c)) {
    const WaterSituation &a = situation_of(c.water, water.from), &b = situation_of(c.water, water.to);
    if (a.formula || b.formula) continue;
    const Real level = std::lerp(elevation_at(a.phreatic_line, x), elevation_at(b.phreatic_line, x), water.share);
    if (level > ground + least_depth && level > highest.level) highest = {level, b.name};
  }
  return highest;
}

/// At the left and the right end of the soil.
std::array<FreeWater, 2> free_water_at_ends(const Case& c, const Model& model)
{
  std::array<FreeWater, 2> ends;
  const Overburden overburden(model);
  if (!c.water.is_given() || !overburden.is_known()) return ends;
  const Columns columns = columns_of_section(*model.mesh);
  bool found_soil = false;
  for (Index k = 0; k < columns.n; ++k) {
    const Real x = columns.left + (static_cast<Real>(k) + 0.5) * columns.width;
    const std::optional<Real> ground = overburden.ground(x);
    if (!ground) continue;
    if (!found_soil) ends[0] = highest_at(x, *ground, c);
    found_soil = true;
    ends[1] = highest_at(x, *ground, c);
  }
  return ends;
}

}  // namespace

FloodLevel find_flood_level(const Case& whole, const Model& model)
{
  const FloodCase& flood = whole.flood;
  if (!flood.asks()) return {};
  const std::array<FreeWater, 2> ends = free_water_at_ends(whole, model);
  FloodLevel level{.value = flood.water_level, .origin = "flood.water_level", .river = {}};
  if (flood.river != RiverSide::deduced) level.river = flood.river == RiverSide::left ? Facing::left : Facing::right;
  const bool differ = ends[0].level != ends[1].level;
  if (!level.river && differ) level.river = ends[0].level > ends[1].level ? Facing::left : Facing::right;
  if (level.is_known()) return level;
  const FreeWater& water = ends[level.river == Facing::right ? 1 : 0];
  if (water.level == no_water) return level;
  level.value = water.level;
  level.origin = fmt::format("the highest free water at {} of the section{}",
      !level.river                  ? "both ends"
      : level.river == Facing::left ? "the left end"
                                    : "the right end",
      water.situation.empty() ? "" : fmt::format(", in the situation \"{}\"", water.situation));
  return level;
}

}  // namespace terp
