// The stage is copied, its heads are moved, and the calculations of the old stage are kept as drawings under a new
// name: their factors and slices belong to the old water. Of a first stage the copy becomes the second, without its
// state points, since the first stage already carries the soil's history.

#include "import/dstability/river_level.hpp"

#include "math/errors.hpp"
#include "import/dstability/section_layout.hpp"
#include "import/dstability/reported_texts.hpp"
#include "import/dstability/trigger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace terp {
namespace {

constexpr Real off_the_end = 1e-6;  // [m] from an end
constexpr Real beneath = 0.01;      // [m]: coordinates of drawings are in cm
constexpr Real same = 0.005;        // [m]: the same in cm

RiverInStage river_in(const StixSection& section, const StixRiver& river, Vec<2> ends)
{
  const auto level_at = [&](bool left) {
    return section.column(left ? ends[0] + off_the_end : ends[1] - off_the_end).now().water().phreatic();
  };
  const bool at_left = river.side == "left";
  return {.at_left = at_left, .ends = ends, .level = level_at(at_left), .inland = level_at(!at_left)};
}

/// A level below all ground is no river: it is mistyped, or of another datum.
void check_level(const StixStage& stage, Real level)
{
  std::vector<DrawnRegion> drawn;
  for (const StixLayer& layer : stage.layers) drawn.push_back({layer.label, layer.outline});
  std::vector<DrawnExcavation> pits;
  for (const StixLine& pit : stage.excavations) pits.push_back({"", pit});
  const Real lowest = std::ranges::min(ground_line(drawn, pits), {}, [](const Vec<2>& x) { return x[1]; })[1];
  if (level < lowest - beneath)
    throw InputError(
        {"", fmt::format("no river stands at {:.2f} m: the lowest ground of the section is at {:.2f} m", level, lowest),
            "Give the level in the datum of the file, not below its lowest ground: --river LEVEL.", ""});
}

Sentence rule_of(const RiverInStage& river, Real level)
{
  return filled<reported_texts::river_moved>(
      level, river.level, river.inland, level < river.level ? filled<reported_texts::after_fall>() : Sentence{});
}

/// They stay to be drawn, without a factor or slices that could be taken for those of this water.
void name_as_of_the_file(StixScenario& scenario, std::size_t from, std::size_t to, Real level)
{
  for (StixCalculation& calculation : scenario.calculations) {
    if (calculation.stage != from) continue;
    calculation.stage = to;
    if (!calculation.result) continue;
    StixResult& result = *calculation.result;
    const std::string name = calculation.label.empty() ? result.name : calculation.label;
    const std::string factor =
        std::isfinite(result.factor_of_safety) ? fmt::format(", factor {:.4f}", result.factor_of_safety) : "";
    calculation.label = fmt::format("{} (river at {:.2f} m{})", name, level, factor);
    result.factor_of_safety = not_given;
    result.slices.clear();
  }
}

}  // namespace

RiverLevel with_river_level(
    const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis, Real level)
{
  const StixSection section(project, scenario, stage, basis);
  const BoundingBox box = box_around(section.stage().layers);
  const Vec<2> ends{box.low[0], box.high[0]};
  RiverLevel moved{project, stage == 0 ? 1 : stage, find_river(section, ends), {}};
  check_river_to_move(
      section, moved.river, moved.river.side == "right" ? ends[1] - off_the_end : ends[0] + off_the_end);
  check_level(section.stage(), level);
  const RiverInStage river = river_in(section, moved.river, ends);
  if (std::abs(level - river.level) < same) {
    moved.stage = stage;
    moved.sentence = filled<reported_texts::river_there_already>(river.level);
    return moved;
  }
  StixStage changed = with_river_at(section, river, level);
  changed.label = fmt::format("{}, river at {:.2f} m", changed.label, level);
  moved.sentence = rule_of(river, level);
  StixScenario& of = moved.project.scenarios[scenario];
  if (stage == 0) std::erase_if(of.calculations, [](const StixCalculation& c) { return c.stage > 0; });
  name_as_of_the_file(of, stage, moved.stage, river.level);
  if (stage > 0) {
    of.stages[stage] = std::move(changed);
    return moved;
  }
  changed.state_points.clear();  // the first stage has them: its soil carries no more for having a stage after it
  changed.state_lines.clear();
  of.stages.resize(1);
  of.stages.push_back(std::move(changed));
  return moved;
}

}  // namespace terp
