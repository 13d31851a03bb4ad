// The ground that holds the water is found at t = 0 by the functions that give the verdict in the run. Without a level
// there is one warning, and nothing else is checked. A narrow crest is measured on the drawn outlines, as columns of
// one cell cannot show it. What concerns the whole run asks model.whole(), the case without the changes of its stages.

#include "run/findings/flood_warnings.hpp"

#include "model/water/free_water.hpp"
#include "model/ground/ground_section.hpp"
#include "model/soils/overburden.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace terp {

namespace {

constexpr Real slide_time =
    0.3;  // in which the retreat of a crest is a slide and not creep (run/measure/crest.cpp) [s]

Problem no_level(const Model& model)
{
  const Case& c = model.description;
  const auto& bodies = c.bodies;
  const bool formula = c.water.is_given() && changes_with_time(model.whole());
  const bool points = std::ranges::any_of(bodies, [](const BodyCase& body) { return !body.points_file.empty(); });
  const char* why = !c.water.is_given() ? "The case has no [water], whose free water would be the level."
                    : formula ? "The pressure of the water is a formula of the time, from which no level follows."
                    : points  ? "Bodies come as points, so the ground under the water is not known."
                    : model.flood_level.river
                        ? "The water of no situation stands above the ground at the river's end of the section."
                        : "The water of no situation stands above the ground at an end of the section.";
  return {"flood", "there is no water level, and no verdict", fmt::format("{}\nGive flood.water_level in m.", why),
      "flood.water_level", true};
}

/// The level of a situation at the river; beyond its ends a line keeps its level [m].
Real level_at_river(const Model& model, std::size_t number)
{
  const Case& whole = model.whole();
  const auto& line = situation_of(whole.water, number).phreatic_line;
  if (line.empty()) return FreeWater::none;
  return model.flood_level.river == Facing::right ? line.back()[1] : line.front()[1];
}

/// Stages have other water than the start, and in none the river stands higher.
std::optional<Problem> find_low_flood(const Model& model)
{
  const Case& whole = model.whole();
  const bool of_case = whole.flood.water_level == model.flood_level.value;
  if (of_case || model.flood_level.at_both_ends || changes_with_time(whole)) return std::nullopt;
  const auto asked_for = situations_asked_for(whole, whole.stages.size());
  const auto is_low = [&](std::size_t number) { return level_at_river(model, number) < level_at_river(model, 0); };
  const bool any_other = std::ranges::any_of(asked_for, [](std::size_t number) { return number > 0; });
  const Real first = level_at_river(model, 0);
  const auto is_higher = [&](std::size_t number) { return level_at_river(model, number) > first; };
  if (first == FreeWater::none || !any_other || std::ranges::any_of(asked_for, is_higher)) return std::nullopt;
  return Problem{"flood",
      std::ranges::any_of(asked_for, is_low)
          ? "no stage has higher water at the river than the start, and one has lower water"
          : "no stage has higher water at the river than the start",
      fmt::format(
          "The verdict is for the {:.4g} m of the start. Where a stage is the flood, look at its water, and at\n"
          "the river's end of its phreatic line.",
          model.flood_level.value),
      "flood.water_level", true};
}

/// Heads of layers that stay or fall where the river rises, or rise above it: of lines at the river's end, of computed
/// water at its side.
std::optional<Problem> find_idle_head(const Model& model)
{
  constexpr Real little = 0.1;  // [m]
  const Case& whole = model.whole();
  if (!model.flood_level.river || changes_with_time(whole)) return std::nullopt;
  const bool on_right = model.flood_level.river == Facing::right;
  const WaterSituation& start = whole.water.start;
  for (const std::size_t number : situations_asked_for(whole, whole.stages.size())) {
    const Real rise = level_at_river(model, number) - level_at_river(model, 0);
    if (number == 0 || !(rise > little)) continue;
    const WaterSituation& of = situation_of(whole.water, number);
    const std::string path = fmt::format("water.situation[{}]", number - 1);
    const auto doubt = [&](std::string key, const std::string& name, Real before, Real now) {
      return Problem{std::move(key),
          fmt::format("the head `{}` {} where the river rises", name, now < before ? "falls" : "stays"),
          fmt::format(
              "At the river it is {:.4g} m in the water `{}` and {:.4g} m at the start; the river rises by {:.3g} m. "
              "Give the\nhead that the layer has then, or leave it if the layer does not feel the river.",
              now, of.name, before, rise),
          "water.situation", false, {"water"}};
    };
    const auto at_river = [&](const std::vector<Vec<2>>& line) { return on_right ? line.back()[1] : line.front()[1]; };
    const Real level = level_at_river(model, number);
    const auto doubt_above = [&](std::string key, const std::string& name, Real head) {
      return Problem{std::move(key), fmt::format("the head `{}` stands above the river that feeds it", name),
          fmt::format(
              "At the river it is {:.4g} m in the water `{}`, and the river {:.4g} m. A head is an elevation in "
              "the frame of the\nmesh, no height above the layer.",
              head, of.name, level),
          "water.situation", false, {"water"}};
    };
    for (const HeadLine& line : of.head_lines) {
      if (at_river(line.places) > level + little)
        return doubt_above(fmt::format("{}.head_lines.\"{}\"", path, line.name), line.name, at_river(line.places));
      const auto before = std::ranges::find(start.head_lines, line.name, &HeadLine::name);
      if (before == start.head_lines.end() || before->places.empty() ||
          at_river(line.places) > at_river(before->places))
        continue;
      const bool same = line.places == before->places;
      return doubt(same ? path : fmt::format("{}.head_lines.\"{}\"", path, line.name), line.name,
          at_river(before->places), at_river(line.places));
    }
    const SectionSide side = on_right ? SectionSide::right : SectionSide::left;
    for (const SideHead& head : of.seepage.boundary) {
      const auto before = std::ranges::find_if(start.seepage.boundary,
          [&](const SideHead& other) { return other.side == side && other.from == head.from && other.to == head.to; });
      if (head.side == side && head.head[0][1] > level + little) return doubt_above(path, head.name, head.head[0][1]);
      if (head.side != side || before == start.seepage.boundary.end() || head.head[0][1] > before->head[0][1]) continue;
      return doubt(path, head.name, before->head[0][1], head.head[0][1]);
    }
  }
  return std::nullopt;
}

/// At the end strengths are divided by less than 1.
std::optional<Problem> find_raised_strength(const Model& model)
{
  const Case& whole = model.whole();
  const bool staged = !whole.stages.empty() && whole.stages.back().changed;
  const Real factor = staged ? whole.stages.back().changed->at_strength : whole.at_strength;
  if (!(factor < 1.0)) return std::nullopt;
  return Problem{"at_strength", "the verdict is of soil that is stronger than it is",
      fmt::format("At the end strengths are divided by {:.4g}: they are {:.4g} times those of the soil. A section that "
                  "shall be\nweaker has at_strength above 1, as {:.4g}.",
          factor, 1.0 / factor, 1.0 / factor),
      "at_strength", false, {"stage"}};
}

/// A stage may seek rest with much damping; that of the verdict is slowed by it.
std::optional<Problem> find_damped_end(const Model& model)
{
  constexpr Real much = 0.5;
  const Case& whole = model.whole();
  if (whole.stages.empty() || !whole.stages.back().changed) return std::nullopt;
  const Real alpha = whole.stages.back().changed->forces.local_damping;
  if (!(alpha > much) || whole.forces.local_damping > much) return std::nullopt;  // that is told of the case
  return Problem{fmt::format("stage[{}].set", whole.stages.size() - 1),
      fmt::format("local damping of {} slows the slide of the last stage", alpha),
      fmt::format(
          "Soil falls with {:.2g} of gravity, and a failure is as much too slow. Usual: 0.02 to 0.1 in the stage "
          "of the verdict.",
          1.0 - alpha),
      "forces.damping.local", false, {"stage"}};
}

/// The ground that holds the water, drawn narrower at its top than two cells.
std::optional<Problem> find_narrow_crest(const Model& model, const Columns& columns, ColumnRange range, Real height)
{
  const Overburden overburden(model);
  if (!overburden.is_known() || !std::isfinite(height)) return std::nullopt;
  constexpr int n = 20;  // places in a column
  const Real spacing = columns.width / n;
  const auto place = [&](Index k) { return columns.left + (static_cast<Real>(k) + 0.5) * spacing; };
  Real top = -INFINITY;
  Index at = 0;
  for (Index k = range.first * n; k < (range.last + 1) * n; ++k)
    if (const auto y = overburden.ground(place(k)); y && *y > top) top = *y, at = k;
  const Real below = 0.1 * columns.width;
  const auto is_top = [&](Index k) { return overburden.ground(place(k)).value_or(-INFINITY) > top - below; };
  Index left = at, right = at;
  while (left > range.first * n && is_top(left - 1)) --left;
  while (right < (range.last + 1) * n - 1 && is_top(right + 1)) ++right;
  const Real width = static_cast<Real>(right - left + 1) * spacing;
  if (width >= 2.0 * columns.width) return std::nullopt;
  return Problem{"mesh.cell", "the crest is narrower than two cells",
      fmt::format("At x = {:.4g} m the ground reaches {:.4g} m; {:.2g} m lower it is {:.2g} m wide, on cells of {:.3g} "
                  "m.\nIt counts as {:.4g} m high, and has few ways to fail. Give smaller cells.",
          0.5 * (place(left) + place(right)), top, below, width, columns.width, height),
      "flood", false, {"mesh", "flood"}};
}

/// water_level is of the case, and the water at the river stands elsewhere: pressures and verdict are of two levels.
std::optional<Problem> find_other_water(const Model& model)
{
  constexpr Real least = 0.01;  // [m]
  const Case& whole = model.whole();
  const FloodLevel& level = model.flood_level;
  if (whole.flood.water_level != level.value || !level.river || changes_with_time(whole)) return std::nullopt;
  const FreeWater water = free_water_at_ends(whole, model, whole.stages.size())[level.river == Facing::right ? 1 : 0];
  if (water.level == FreeWater::none || std::abs(water.level - level.value) < least) return std::nullopt;
  return Problem{"flood.water_level", "the verdict is for another level than that of the water",
      fmt::format(
          "The water at the river stands at {:.4g} m, water_level is {:.4g} m. Give both one level: pressures and\n"
          "strengths follow the water, the verdict follows water_level.",
          water.level, level.value),
      "flood.water_level"};
}

}  // namespace

std::vector<Problem> find_flood_warnings(const Model& model, const State& state)
{
  const FloodCase& flood = model.description.flood;
  const Real level = model.flood_level.value;
  if (!flood.asks()) return {};
  if (!model.flood_level.is_known()) return {no_level(model)};
  const StandingGround ground = standing_ground(model, state.points);
  const ColumnRange range = columns_of_barrier(ground, model.flood_level.river);
  const Barrier barrier = find_barrier(ground, range);
  std::vector<Real> heights;
  std::ranges::copy_if(ground.heights, std::back_inserter(heights), [](Real h) { return std::isfinite(h); });
  if (heights.empty()) return {};
  std::vector<Problem> warnings;
  for (auto doubt : {find_low_flood(model), find_other_water(model), find_idle_head(model), find_raised_strength(model),
           find_damped_end(model), find_narrow_crest(model, columns_of_section(*model.mesh), range, barrier.height)})
    if (doubt) warnings.push_back(std::move(*doubt));
  const auto warn = [&](const char* key, std::string what, std::string detail) {
    warnings.push_back({std::string("flood.") + key, std::move(what), std::move(detail), std::string("flood.") + key});
  };
  const Real needed = level + flood.smallest_freeboard;
  if (barrier.height < needed)
    warn("water_level", "it floods from the start",
        fmt::format("The highest ground between river and land stands at {:.4g} m, less than {:.4g} m.", barrier.height,
            needed));
  else if (barrier.width < flood.smallest_width)
    warn("smallest_width", "it floods from the start",
        fmt::format("The ground is {:.4g} m wide at {:.4g} m, less than {:.4g} m.", barrier.width, level,
            flood.smallest_width));
  else if (flood.asks_profile() && !place_of_profile(ground, range, flood.profile_width, flood.profile_slope))
    warn("smallest_profile", "it floods from the start",
        fmt::format("A profile of {:g} m at {:.4g} m with slopes of 1:{:g} fits nowhere in the ground as it is drawn.",
            flood.profile_width, level, flood.profile_slope));
  if (model.flood_level.at_both_ends && barrier.height >= level)
    warn("river", "the water stands equally high at both ends of the section",
        fmt::format("It is {:.4g} m there, and the ground between reaches {:.4g} m: nothing has to be kept dry.\n"
                    "Beyond its ends a phreatic line keeps its level; let it fall to that of the land.",
            level, barrier.height));
  else if (std::ranges::min(heights) >= level)
    warn("water_level", "no ground lies below the water",
        fmt::format("The lowest ground stands at {:.4g} m: nothing has to be kept dry at {:.4g} m.",
            std::ranges::min(heights), level));
  if (const Real every = model.description.output.ledger_every; every > slide_time)
    warnings.push_back({"output.ledger.every", "rows of the ledger are too rare to tell slides from creep",
        fmt::format("A crest that retreats within {:g} s slides; between rows of {:g} s creep counts as a slide, too.\n"
                    "Give {:g} s or less.",
            slide_time, every, slide_time),
        "output.ledger.every"});
  const Real at_river = flood.river == RiverSide::left ? heights.front() : heights.back();
  if (flood.river != RiverSide::deduced && at_river >= level)
    warn("river", "the river's end of the section lies above the water",
        fmt::format(
            "The ground there stands at {:.4g} m, the water at {:.4g} m. Name the other end.", at_river, level));
  return warnings;
}

}  // namespace terp
