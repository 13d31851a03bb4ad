#include "model/ground/flood_level.hpp"

#include "model/water/free_water.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real least_difference = 1e-6;  // of levels at the two ends [m]

}  // namespace

bool changes_with_time(const Case& whole)
{
  return std::ranges::any_of(situations_asked_for(whole, whole.stages.size()),
      [&](std::size_t k) { return situation_of(whole.water, k).formula_changes; });
}

FloodLevel find_flood_level(const Case& whole, const Model& model)
{
  const FloodCase& flood = whole.flood;
  if (!flood.asks()) return {};
  const std::array<FreeWater, 2> ends = free_water_at_ends(whole, model, whole.stages.size());
  const bool differ = std::abs(ends[0].level - ends[1].level) > least_difference;
  const bool both = ends[0].level != FreeWater::none && !differ;
  FloodLevel level{.value = flood.water_level, .origin = "flood.water_level", .river = {}, .at_both_ends = both};
  if (flood.river != RiverSide::deduced) level.river = flood.river == RiverSide::left ? Facing::left : Facing::right;
  if (!level.river && differ) level.river = ends[0].level > ends[1].level ? Facing::left : Facing::right;
  if (level.is_known()) return level;
  const FreeWater& water = ends[level.river == Facing::right ? 1 : 0];
  if (water.level == FreeWater::none) return level;
  level.value = water.level;
  level.origin = fmt::format("the highest free water at {} of the section{}",
      !level.river                  ? "both ends"
      : level.river == Facing::left ? "the left end"
                                    : "the right end",
      water.situation.empty() ? "" : fmt::format(", in the situation \"{}\"", water.situation));
  return level;
}

}  // namespace terp
