#include "report/failure_json.hpp"

#include "report/backdrop.hpp"
#include "report/entry_point.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

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

Json failure_json(const RunResults& run, const FirstGround& first)
{
  const Summary& s = run.summary.values;
  Json passes = Json::array();
  for (const PassTime& pass : s.passes) passes.push_back({{"name", pass.name}, {"seconds", pass.seconds}});
  return {{"passes", std::move(passes)}, {"events", summary_is_behind(run) ? Json() : events_json(s, first)}};
}

}  // namespace terp
