// Heads rise first; the phreatic line is then kept below ground that was dry, also at corners of the ground between its
// places. Last it is level from the river to the shore.

#include "import/dstability/trigger.hpp"

#include "math/errors.hpp"
#include "model/water/water_pressure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace terp {
namespace {

constexpr Real ten_thousand = 1e4;  // a factor in the case has four decimals, rounded up
constexpr Real step = 0.05;         // [m] along the section, in the search for the shore
constexpr Real least_drop = 0.1;    // [m] from river to land, or back: less does not say how heads follow the river

/// x at which the ground first stands at the level, from the river on. Throws InputError where it nowhere does.
Real shore(const StixSection& section, const RiverInStage& river, Real level)
{
  const Real from = river.ends[river.at_left ? 0 : 1], to = river.ends[river.at_left ? 1 : 0];
  const Real onwards = to > from ? 1.0 : -1.0;
  Real highest = -1e30;
  for (Real x = from + onwards * 1e-6; onwards * (to - x) > 0.0; x += onwards * step) {
    const Real ground = section.column(x).ground();
    if (ground >= level) return x;
    if (ground > highest) highest = ground;
  }
  throw InputError({section.stage().label, fmt::format("a river at {:.2f} m would flood the whole section", level),
      fmt::format("Its highest ground is at {:.2f} m. Give a lower level.", highest), ""});
}

/// Level from the river to the shore, then as it is.
StixLine with_shore(StixLine line, const RiverInStage& river, Real shore, Real level)
{
  if (!line.empty() && line.front()[0] > line.back()[0]) std::ranges::reverse(line);
  std::erase_if(line, [&](const Vec<2>& x) { return river.at_left ? x[0] <= shore : x[0] >= shore; });
  const Vec<2> far{river.ends[river.at_left ? 0 : 1], level}, near{shore, level};
  const bool is_wet = std::abs(shore - far[0]) > step;  // else the ground stands above the river from its end on
  if (is_wet) line.insert(river.at_left ? line.begin() : line.end(), near);
  line.insert(river.at_left ? line.begin() : line.end(), far);
  return line;
}

/// The line after its heads moved, below ground that was dry: also between its points, where the ground has corners.
/// In the order of x.
StixLine below_dry_ground(StixLine before, StixLine after, const StixSection& section)
{
  if (before.front()[0] > before.back()[0]) std::ranges::reverse(before), std::ranges::reverse(after);
  const auto kept_at = [&](Real x) {  // not given: the moved line may stay
    const Real ground = section.column(x).ground();
    return elevation_at(before, x) <= ground && elevation_at(after, x) > ground ? ground : not_given;
  };
  std::set<Real> corners;
  for (const StixLayer& layer : section.stage().layers)
    for (const Vec<2>& x : layer.outline)
      if (x[0] > after.front()[0] && x[0] < after.back()[0] && !std::isnan(kept_at(x[0]))) corners.insert(x[0]);
  StixLine line;
  for (const Vec<2>& x : after) {
    for (; !corners.empty() && *corners.begin() <= x[0]; corners.erase(corners.begin()))
      if (*corners.begin() < x[0]) line.push_back({*corners.begin(), kept_at(*corners.begin())});
    const Real kept = kept_at(x[0]);
    line.push_back({x[0], std::isnan(kept) ? x[1] : kept});
  }
  return line;
}

}  // namespace

Real river_below_crest(Real height_of_dike) { return std::max(0.05, height_of_dike / 40.0); }

FolderTrigger trigger_after(const FoundFactors& found)
{
  if (!found.stands || (!found.fails && !found.creeps))
    throw RunError(
        "terp stability found no factor: nothing is known of how weak the soil must be to slide\n  Look at "
        "stability/stability.txt in the folder. Give the factor yourself: --trigger strength=F");
  const std::string stands = fmt::format("terp stability on these cells: it stands at a factor of {:g}", *found.stands);
  if (!found.fails)
    return {.origin = fmt::format("No trigger: {}, and is undecided up to {:g}, where it creeps and does not fail "
                                  "(stability/). Give the factor yourself: --trigger strength=F.",
                stands, *found.creeps)};
  const Real factor = std::ceil(ten_thousand * *found.fails) / ten_thousand;
  const std::string bounds = fmt::format("{}, and fails at {:g} (stability/).", stands, factor);
  if (factor <= 1.0)
    return {.origin = "No trigger was needed: the section fails at its own strengths. " + bounds, .needs_hold = true};
  return {.kind = TriggerKind::strength, .value = factor, .origin = bounds};
}

StixStage with_river_at(const StixSection& section, const RiverInStage& river, Real level)
{
  StixStage stage = section.stage();
  if (stage.water.is_mesh || !stage.water.phreatic)
    throw InputError({stage.label, "its water is a mesh of pressures, in which no river can be moved",
        "Make a stage with the other river in D-Stability, and import that one.", ""});
  const Real rise = level - river.level, over_land = river.level - river.inland;
  if (std::abs(over_land) < least_drop)
    throw InputError({stage.label,
        fmt::format(
            "the river stands at {:.2f} m, the phreatic line at the land's end at {:.2f} m", river.level, river.inland),
        "From water that is level nobody can tell how the heads in the ground follow the river. Make a stage with the "
        "other river in D-Stability, and import that one.",
        ""});
  for (std::size_t k = 0; k < stage.water.head_lines.size(); ++k) {
    StixLine& line = stage.water.head_lines[k].line;
    const StixLine before = line;
    for (Vec<2>& x : line) x[1] += rise * std::clamp((x[1] - river.inland) / over_land, 0.0, 1.0);
    if (k == *stage.water.phreatic) line = below_dry_ground(before, line, section);
  }
  StixLine& phreatic = stage.water.head_lines[*stage.water.phreatic].line;
  phreatic = with_shore(phreatic, river, shore(section, river, level), level);
  return stage;
}

RaisedRiver raise_river(const StixSection& section, const RiverInStage& river, Real asked)
{
  const Real highest = std::floor(100.0 * (river.crest - river_below_crest(river.height))) / 100.0;
  const Real level = std::isnan(asked) ? highest : asked;
  if (!(level > river.level && level <= river.crest))
    throw InputError({section.stage().label, fmt::format("the river cannot be raised to {:.2f} m", level),
        fmt::format("It stands at {:.2f} m in this stage, the crest at {:.2f} m. Give a level between: --trigger "
                    "water=LEVEL.",
            river.level, river.crest),
        ""});
  return {level, with_river_at(section, river, level),
      fmt::format("Trigger: the river rises from {:.2f} to {:.2f} m, {:.2f} m below the crest. The heads in the ground "
                  "rise in proportion to their height over the phreatic line at the land's end ({:.2f} m). Undrained "
                  "strengths are those of this water.",
          river.level, level, river.crest - level, river.inland)};
}

StixProject with_stage(StixProject project, std::size_t scenario, std::size_t after, StixStage stage)
{
  auto& stages = project.scenarios[scenario].stages;
  stages.resize(after + 1);
  stages.push_back(std::move(stage));
  return project;
}

}  // namespace terp
