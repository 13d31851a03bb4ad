#include "report/failure_json.hpp"

#include "report/entry_point.hpp"

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

/// The slides of summary.json, each with the place at which it enters the ground.
Json slides_with_entries(const Summary& s, std::span<const float> first_surface)
{
  Json slides = slides_json(s);
  for (std::size_t k = 0; k < s.slides.size(); ++k) {
    const auto entry = entry_point(s.slides[k], first_surface);
    slides[k]["entry"] = entry ? Json{{"x", entry->x}, {"y", entry->y}, {"zone", entry->zone}} : Json();
  }
  return slides;
}

Json events_json(const Summary& s, std::span<const float> first_surface)
{
  const auto or_null = [](const std::optional<Real>& value) { return value ? Json(*value) : Json(); };
  Json slides = slides_with_entries(s, first_surface);
  const auto slide_or_null = [&](std::size_t k) { return k < slides.size() ? slides[k] : Json(); };
  Json first = slide_or_null(0), second = slide_or_null(1), slip = slides.empty() ? Json() : first["slip_surface"];
  Json stages = Json::array();
  for (const StageSummary& stage : s.stages)
    stages.push_back({{"name", stage.name}, {"start", stage.record.start}, {"end", stage.record.end}});
  return {{"slides", std::move(slides)}, {"first_slide", std::move(first)}, {"second_slide", std::move(second)},
      {"moved_volume", s.moved_volume}, {"moved_fraction", s.moved_fraction}, {"moved_distance", s.moved_distance},
      {"intact_fraction", or_null(s.intact_fraction)}, {"free_toe", s.free_toe},
      {"facing", s.facing ? Json(*s.facing == Facing::left ? "left" : "right") : Json()}, {"run_out", s.run_out},
      {"front_x", s.front_x}, {"remaining_crest", {{"x", or_null(s.crest_x)}, {"y", or_null(s.crest_y)}}},
      {"stages", std::move(stages)}, {"residual_height", or_null(s.residual_height)}, {"flood", flood_json(s)},
      {"slip_surface", std::move(slip)}};
}

}  // namespace

Json failure_json(const RunResults& run, std::span<const float> first_surface, const std::vector<std::string>& warnings)
{
  const Summary& s = run.summary.values;
  Json passes = Json::array();
  for (const PassTime& pass : s.passes) passes.push_back({{"name", pass.name}, {"seconds", pass.seconds}});
  return {{"passes", std::move(passes)}, {"events", summary_is_behind(run) ? Json() : events_json(s, first_surface)},
      {"warnings", warnings}};
}

}  // namespace terp
