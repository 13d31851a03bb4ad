// The level is compared with the ground of the first and the last column that hold soil. The mesh may reach further
// than that. The ground is that of the drawn outlines, not of the points, so the answer does not change while soil
// moves.

#include "model/water/free_water.hpp"

#include "model/ground/flood_level.hpp"
#include "model/ground/ground_section.hpp"
#include "model/soils/overburden.hpp"
#include "model/parts/stage_case.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>

namespace terp {
namespace {

/// x: where the soil ends [m].
FreeWater highest_at(Real x, Real ground, const Case& c, std::span<const std::size_t> situations)
{
  FreeWater highest;
  for (const std::size_t number : situations) {
    const WaterSituation& situation = situation_of(c.water, number);
    const Real level = level_at(x, ground, c.water, situation);
    if (level > ground + least_free_depth && level > highest.level) highest = {level, situation.name};
  }
  return highest;
}

}  // namespace

std::vector<std::size_t> situations_asked_for(const Case& whole, std::size_t n_stages)
{
  std::vector<std::size_t> numbers{0};
  for (std::size_t k = 0; k < std::min(n_stages, whole.stages.size()); ++k)
    if (const StageWater water = water_of_stage(whole, k); water.given) numbers.push_back(water.to);
  for (const WaterKnot& knot : knots_of(whole.water)) numbers.push_back(knot.situation);
  return numbers;
}

std::array<FreeWater, 2> free_water_at_ends(const Case& whole, const Model& model, std::size_t n_stages)
{
  std::array<FreeWater, 2> ends;
  const Overburden overburden(model);
  if (!whole.water.is_given() || changes_with_time(whole) || !overburden.is_known()) return ends;
  const std::vector<std::size_t> situations = situations_asked_for(whole, n_stages);
  const Columns columns = columns_of_section(*model.mesh);
  bool found_soil = false;
  for (Index k = 0; k < columns.n; ++k) {
    const Real x = columns.left + (static_cast<Real>(k) + 0.5) * columns.width;
    const std::optional<Real> ground = overburden.ground(x);
    if (!ground) continue;
    if (!found_soil) ends[0] = highest_at(x, *ground, whole, situations);
    found_soil = true;
    ends[1] = highest_at(x, *ground, whole, situations);
  }
  return ends;
}

RiverBeforeTrigger river_before_trigger(const Model& model)
{
  const Case& whole = model.whole();
  const auto raises = [](const StageCase& stage) { return stage.trigger && !stage.water.empty(); };
  const auto first = std::ranges::find_if(whole.stages, raises);
  if (first == whole.stages.end()) return {};
  const auto n_stages = static_cast<std::size_t>(first - whole.stages.begin());
  const auto level_with = [&](std::size_t n) {
    const auto ends = free_water_at_ends(whole, model, n);
    const Facing river = model.flood_level.river.value_or(ends[0].level > ends[1].level ? Facing::left : Facing::right);
    return ends[river == Facing::right ? 1 : 0].level;
  };
  if (level_with(whole.stages.size()) == FreeWater::none) return {};
  return {n_stages, std::min(model.flood_level.value, level_with(n_stages))};
}

}  // namespace terp
