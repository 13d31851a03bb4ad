#include "report/failure_json.hpp"

#include "report/story.hpp"

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

Json events_json(const Summary& s)
{
  const auto or_null = [](const std::optional<Real>& value) { return value ? Json(*value) : Json(); };
  Json slides = slides_json(s);
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

Json failure_json(const RunResults& run, const std::vector<std::string>& warnings)
{
  const Summary& s = run.summary.values;
  const bool behind = summary_is_behind(run);
  Json passes = Json::array(), checks = Json::array(), audit;
  for (const PassTime& pass : s.passes) passes.push_back({{"name", pass.name}, {"seconds", pass.seconds}});
  for (const Check& check : list_checks(run))
    checks.push_back({{"name", check.name}, {"value", check.value}, {"passed", check.passed}});
  if (!behind)
    audit = {{"points", s.n_points}, {"points_eps_eq_p_fell", s.points_eps_eq_p_fell},
        {"points_su_rose", s.points_su_rose}, {"energy_balance_error", s.energy_balance_error},
        {"clamped_points", s.clamped_points}, {"points_left", s.points_left}};
  std::vector<std::string> cautions = find_cautions(run);
  cautions.insert(cautions.end(), warnings.begin(), warnings.end());
  return {{"passes", std::move(passes)}, {"events", behind ? Json() : events_json(s)}, {"story", tell_story(run)},
      {"warnings", cautions}, {"checks", std::move(checks)}, {"audit", std::move(audit)}};
}

}  // namespace terp
