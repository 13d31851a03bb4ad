// Slides are those of the summary. What needs the ground of t = 0 is added here: the entry and the edge of the crest. A
// slip line is turned so that it begins at its upper end, and "backwards" is against the motion. For the entry, heights
// are shares of that from the foot, at the end that the slope faces, to the highest ground. What is not known is null.

#include "page/failure_json.hpp"

#include "math/interpolate.hpp"
#include "page/backdrop.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

constexpr Real crest_share = 0.05;  // of the height of the slope below the highest ground still counts as crest
constexpr Real deepest = 0.4;       // of the height of the slope: an end below that does not come up to the ground
constexpr Real little = 0.05;       // of the height of the slope: an end above the ground by less lies at it

/// How the upper end of a line rises backwards over its last piece that is at least `length` long; at least 45 degrees
/// [-]. line: from the upper end on.
Real steepness(std::span<const Vec<2>> line, Real length)
{
  Real rise = 1.0;
  for (const Vec<2>& x : line.subspan(1)) {
    const Real run = std::abs(x[0] - line[0][0]);
    if (run > 0.0) rise = std::max(1.0, (line[0][1] - x[1]) / run);
    if (run >= length) break;
  }
  return rise;
}

/// Where a line from `end` backwards, which rises by `rise` per metre, meets the ground; none within `longest` [m].
std::optional<Vec<2>> come_up(std::span<const Vec<2>> ground, Vec<2> end, Real backwards, Real rise, Real longest)
{
  constexpr int steps = 200;
  Real before = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const Real run = longest * k / steps, x = end[0] + backwards * run;
    if (x < ground.front()[0] || x > ground.back()[0]) return std::nullopt;
    const Real gap = interpolate(ground, x) - (end[1] + rise * run);
    if (gap <= 0.0) {
      const Real there = k == 0 ? 0.0 : run - longest / steps * (-gap) / (before - gap);
      const Real at = end[0] + backwards * there;
      return Vec<2>{at, interpolate(ground, at)};
    }
    before = gap;
  }
  return std::nullopt;
}

std::string_view zone_of(std::span<const Vec<2>> ground, Vec<2> entry, bool to_the_right, Real foot, Real top)
{
  const auto in_crest = [&](const Vec<2>& place) { return place[1] >= top - crest_share * (top - foot); };
  const auto highest = std::ranges::max_element(ground, {}, [](const Vec<2>& place) { return place[1]; });
  auto low = highest, high = highest;  // ends of the crest
  while (low != ground.begin() && in_crest(*(low - 1))) --low;
  while (high + 1 != ground.end() && in_crest(*(high + 1))) ++high;
  const Real x = entry[0], left = (*low)[0], right = (*high)[0];
  if (x >= left && x <= right) return "crest";
  if (to_the_right ? x < left : x > right) return "beyond_crest";
  return entry[1] - foot >= 0.5 * (top - foot) ? "upper_half" : "lower_half";
}

/// The edge of the crest as it was drawn: a corner near by, else one a little higher up, since all within a twentieth
/// of the height below the highest ground is seen as crest.
std::optional<Real> crest_edge(const FirstGround& first, Real seen)
{
  constexpr Real gentlest = 4.0, level = 0.05;  // slope 1:4; of the height
  if (const auto corner = corner_near(first.outline, seen, first.column)) return corner;
  const std::vector<Vec<2>> ground = places_of(first.surface);
  if (ground.empty()) return std::nullopt;
  const auto [lowest, highest] = std::ranges::minmax(ground, {}, [](const Vec<2>& x) { return x[1]; });
  return corner_near(first.outline, seen, first.column + gentlest * level * (highest[1] - lowest[1]));
}

/// The first of each slope with the edge of the crest as it was drawn.
Json slides_of(const Summary& s, const FirstGround& first)
{
  Json slides = slides_json(s);
  for (std::size_t k = 0; k < s.slides.size(); ++k) {
    const Slide& slide = s.slides[k].slide;
    const auto entry = entry_point(s.slides[k], first.surface);
    slides[k].erase("onset");
    slides[k]["entry"] = entry ? Json{{"x", entry->x}, {"y", entry->y}, {"zone", entry->zone}} : Json();
    const bool is_first = std::none_of(s.slides.begin(), s.slides.begin() + static_cast<std::ptrdiff_t>(k),
        [&](const SlideSummary& before) { return before.slide.facing == slide.facing; });
    const auto edge = is_first ? crest_edge(first, slide.crest_from) : std::nullopt;
    slides[k]["crest_edge"] = edge ? Json(*edge) : Json();
  }
  return slides;
}

Json events_json(const Summary& s, const FirstGround& first)
{
  const auto or_null = [](const std::optional<Real>& value) { return value ? Json(*value) : Json(); };
  Json stages = Json::array();
  for (const StageSummary& stage : s.stages)
    stages.push_back({{"name", stage.name}, {"start", stage.record.start}, {"end", stage.record.end}});
  return {{"slides", slides_of(s, first)}, {"moved_volume", s.moved_volume}, {"moved_fraction", s.moved_fraction},
      {"moved_distance", s.moved_distance}, {"intact_fraction", or_null(s.intact_fraction)}, {"free_toe", s.free_toe},
      {"facing", s.facing ? Json(*s.facing == Facing::left ? "left" : "right") : Json()}, {"run_out", s.run_out},
      {"front_x", s.front_x}, {"remaining_crest", {{"x", or_null(s.crest_x)}, {"y", or_null(s.crest_y)}}},
      {"stages", std::move(stages)}, {"residual_height", or_null(s.residual_height)}, {"flood", flood_json(s)}};
}

}  // namespace

std::optional<EntryPoint> entry_point(const SlideSummary& slide, std::span<const float> places)
{
  std::vector<Vec<2>> line = slide.onset.line;
  const std::vector<Vec<2>> ground = places_of(places);
  if (line.empty() || ground.size() < 2 || !(slide.onset.time < slide.slip.time)) return std::nullopt;
  const bool to_the_right = slide.slide.facing == Facing::right;
  if (!to_the_right) std::ranges::reverse(line);
  const Vec<2> end = line.front();
  if (end[0] < ground.front()[0] || end[0] > ground.back()[0]) return std::nullopt;
  const Real foot = to_the_right ? ground.back()[1] : ground.front()[1];
  const Real top = std::ranges::max(ground, {}, [](const Vec<2>& place) { return place[1]; })[1];
  const Real depth = interpolate(ground, end[0]) - end[1];
  if (depth > deepest * (top - foot) || depth < -little * (top - foot)) return std::nullopt;
  const Real backwards = to_the_right ? -1.0 : 1.0;
  const auto entry = come_up(ground, end, backwards, steepness(line, depth), std::max(depth, 0.0) + little);
  if (!entry) return std::nullopt;
  return EntryPoint{(*entry)[0], (*entry)[1], zone_of(ground, *entry, to_the_right, foot, top)};
}

Json failure_json(const RunResults& run, const FirstGround& first)
{
  const Summary& s = run.summary.values;
  Json passes = Json::array();
  for (const PassTime& pass : s.passes) passes.push_back({{"name", pass.name}, {"seconds", pass.seconds}});
  return {{"passes", std::move(passes)}, {"events", summary_is_behind(run) ? Json() : events_json(s, first)}};
}

}  // namespace terp
