#include "simulation/flood_level.hpp"

#include "simulation/ground_section.hpp"
#include "simulation/overburden.hpp"
#include "simulation/stages.hpp"
#include "water/water_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real least_depth = 1e-6;  // of water that counts as free [m]
constexpr Real no_water = -std::numeric_limits<Real>::infinity();

/// The situations that the case asks for, by their numbers: that of the start, of each stage, and those with a time. Of
/// the last ones all count, whenever the run ends: a run that goes on later is judged against the same level.
std::vector<std::size_t> situations_asked_for(const Case& c)
{
  std::vector<std::size_t> numbers{0};
  for (std::size_t k = 0; k < c.stages.size(); ++k)
    if (const StageWater water = water_of_stage(c, k); water.given) numbers.push_back(water.to);
  for (const WaterKnot& knot : knots_of(c.water)) numbers.push_back(knot.situation);
  return numbers;
}

/// The free water at an end of the section, and the situation in which it stands highest.
struct FreeWater {
  Real level = no_water;  ///< [m]
  std::string situation = {};
};

/// To which the water at the ground rises: the phreatic line, or what the pressure of a formula there says [m].
Real level_at(Real x, Real ground, const WaterCase& water, const WaterSituation& situation)
{
  if (!situation.formula) return elevation_at(situation.phreatic_line, x);
  return ground + unlimited_pressure(water, situation, {x, ground}, 0.0) / water.unit_weight;
}

/// x: where the soil ends [m].
FreeWater highest_at(Real x, Real ground, const Case& c)
{
  FreeWater highest;
  for (const std::size_t number : situations_asked_for(c)) {
    const WaterSituation& situation = situation_of(c.water, number);
    const Real level = level_at(x, ground, c.water, situation);
    if (level > ground + least_depth && level > highest.level) highest = {level, situation.name};
  }
  return highest;
}

/// At the left and the right end of the soil.
std::array<FreeWater, 2> free_water_at_ends(const Case& c, const Model& model)
{
  std::array<FreeWater, 2> ends;
  const Overburden overburden(model);
  if (!c.water.is_given() || changes_with_time(c) || !overburden.is_known()) return ends;
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

bool changes_with_time(const Case& c)
{
  return std::ranges::any_of(
      situations_asked_for(c), [&](std::size_t k) { return situation_of(c.water, k).formula_changes; });
}

FloodLevel find_flood_level(const Case& whole, const Model& model)
{
  const FloodCase& flood = whole.flood;
  if (!flood.asks()) return {};
  const std::array<FreeWater, 2> ends = free_water_at_ends(whole, model);
  const bool differ = std::abs(ends[0].level - ends[1].level) > least_depth;
  const bool both = ends[0].level != no_water && !differ;
  FloodLevel level{.value = flood.water_level, .origin = "flood.water_level", .river = {}, .at_both_ends = both};
  if (flood.river != RiverSide::deduced) level.river = flood.river == RiverSide::left ? Facing::left : Facing::right;
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
