// A key is null where its number would be no probability of the study. So an adaptive method has only the event that it
// looks for. A sweep or a curve has no P over all its realisations. No correlations are given of realisations that were
// chosen by a method. Remarks are the sentences of the text.

#include "batch/adaptive.hpp"
#include "batch/failure_path.hpp"
#include "batch/fragility.hpp"
#include "batch/height_curve.hpp"
#include "batch/study_text.hpp"
#include "io/case/keys.hpp"

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<Real>& value) { return value ? Json(*value) : Json(); }

Json event_json(const EventEstimate& e)
{
  return {{"probability", or_null(e.probability())}, {"low", e.bounds.low}, {"high", e.bounds.high},
      {"happened", e.happened}, {"solved", e.solved}, {"failed", e.failed}};
}

/// Both languages, as the page has them.
Json path_json(const Study& study, const Realisations& rows, std::size_t level)
{
  Json path = Json::array();
  for (const PathEvent& event : failure_path(study, rows, level)) {
    Json json = event_json(event.estimate);
    json.erase("solved"), json.erase("failed");
    json["of"] = event.estimate.solved, json["unknown"] = event.estimate.failed;
    json["event"] = event.key, json["given"] = event.given_key;
    json["name"] = {{"en", event.name.en}, {"nl", event.name.nl}};
    json["given_name"] = {{"en", event.given.en}, {"nl", event.given.nl}};
    path.push_back(std::move(json));
  }
  return path;
}

/// beta of a P: infinite where P is 0 or 1, which becomes null.
Json beta_json(const std::optional<Real>& p) { return p ? Json(reliability_index(*p)) : Json(); }

Json levels_json(const FragilityCurve& curve)
{
  Json levels = Json::array();
  for (const LevelEstimate& at : curve.levels) {
    Json level{{"level", at.level}, {"slide", event_json(at.slide)}, {"flood", event_json(at.flood)},
        {"flood_after_slide", event_json(at.flood_after_slide)}};
    for (const auto& [name, event] : {std::pair("slide", &at.slide), std::pair("flood", &at.flood)})
      level[name]["beta"] = beta_json(event->probability());
    levels.push_back(std::move(level));
  }
  return levels;
}

/// The most probable place of the event, in the units of the keys.
Json design_json(const Study& study, const ReliabilityResult& r)
{
  Json design = Json::array();
  if (r.design_point.empty()) return design;
  const std::vector<Real> values = draw_at(study, r.design_point).inputs;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const RandomNumber& number = study.settings.numbers[k];
    design.push_back({{"key", number.key}, {"value", values[k]}, {"unit", number.unit}});
  }
  return design;
}

Json integral_json(const std::optional<CurveIntegral>& i)
{
  if (!i) return {};
  return {{"probability", i->probability}, {"straight", {i->of_line.low, i->of_line.high}},
      {"never_falling", i->rising ? Json{i->rising->low, i->rising->high} : Json()}, {"beyond", i->beyond}};
}

/// Only the event that the method looks for has a P: its realisations are no random sample.
void add_method(const Study& study, const StudyEstimates& e, Json& json)
{
  const auto& r = e.adaptive.result;
  const auto bounds = r ? rough_bounds(study, *r) : std::nullopt;
  const bool is_hit = r && r->probability > 0.0;
  json["rule_met"] = r.has_value();
  const Json event = is_hit ? Json{{"probability", r->probability}, {"low", bounds ? Json(bounds->low) : Json()},
                                  {"high", bounds ? Json(bounds->high) : Json()}}
                            : Json();
  json["slide"] = study.settings.adaptive.of_flood ? Json() : event;
  json["flood"] = study.settings.adaptive.of_flood ? event : Json();
  json["flood_after_slide"] = Json();
  json["method"] =
      r ? Json{{"probability", is_hit ? Json(r->probability) : Json()}, {"at_most", is_hit ? Json() : Json(r->at_most)},
              {"cov", or_null(r->cov)}, {"beta", is_hit ? beta_json(r->probability) : Json()},
              {"converged", r->converged}, {"design_point", r->design_point}, {"design_values", design_json(study, *r)},
              {"influence", r->importance}}
        : Json();
}

Json group_json(const PairGroup& g) { return {{"pairs", g.n}, {"happened", g.happened}, {"unknown", g.unknown}}; }

Json counts_json(const TwoLevelCounts& c, Real confidence)
{
  const auto rough = c.rough_bounds(confidence);
  return {{"coarse", c.coarse}, {"with_coarse_event", group_json(c.with)}, {"without", group_json(c.without)},
      {"rough", rough ? Json{rough->low, rough->high} : Json()}};
}

/// Of a curve each level of the load has its own.
Json levels_json(const Study& study, const StudyEstimates& e)
{
  const auto of = [&](StudyEvent event) -> const TwoLevelCounts& { return e.sample.levels().of(event); };
  const TwoLevelCounts& slide = of(StudyEvent::slide);
  Json json{{"coarse_realisations", slide.n}, {"pairs", slide.with.n + slide.without.n}, {"coarse_seconds", e.coarse_s},
      {"fine_seconds", e.fine_s}, {"slide", counts_json(slide, study.settings.confidence)},
      {"flood", e.judges_flood ? counts_json(of(StudyEvent::flood), study.settings.confidence) : Json()},
      {"savings", Json()}};
  const auto savings = find_savings(
      of(e.judges_flood ? StudyEvent::flood : StudyEvent::slide), e.coarse_s, e.fine_s, study.settings.confidence);
  if (savings)
    json["savings"] = {{"same_variance", savings->same_variance}, {"same_bounds", or_null(savings->same_bounds)},
        {"best_pairs_per_coarse", savings->best_share}, {"best_same_variance", savings->best_same_variance}};
  return json;
}

/// P at all levels together is nobody's probability: a curve has its own.
void add_events(const Study& study, const Realisations& rows, const StudyEstimates& e, Json& json)
{
  if (info_of(study.settings.estimator).adaptive) {
    add_method(study, e, json);
    return;
  }
  const bool one_p = study.settings.estimator != Estimator::sweep && !study.settings.fragility;
  json["slide"] = one_p ? event_json(e.slide) : Json();
  json["flood"] = one_p && e.judges_flood ? event_json(e.flood) : Json();
  json["flood_after_slide"] = one_p && e.judges_flood ? event_json(e.flood_after_slide) : Json();
  json["flood_after_slide_over_level"] = Json::array();
  for (const HeightPlace& at : flood_after_slide_over_level(study, rows))
    json["flood_after_slide_over_level"].push_back(
        {at.level, or_null(at.event.probability()), at.event.bounds.low, at.event.bounds.high});
  json["failure_path"] = study.settings.fragility ? Json::array() : path_json(study, rows, 0);
  if (study.coarse && one_p) json["multilevel"] = levels_json(study, e);
  if (!study.settings.fragility) return;
  const FragilityCurve curve = estimate_fragility(study, rows);
  json["load"] = study.settings.fragility->label();
  json["judges_flood"] = curve.judges_flood;
  json["levels"] = levels_json(curve);
  for (std::size_t k = 0; k < curve.levels.size(); ++k) json["levels"][k]["failure_path"] = path_json(study, rows, k);
  json["slide_over_levels"] = integral_json(curve.slide);
  json["flood_over_levels"] = integral_json(curve.flood);
}

}  // namespace

std::string study_json(const Study& study, const Realisations& rows)
{
  const StudyEstimates e = estimate(study, rows);
  const StudySettings& s = study.settings;
  Json json{{"title", s.title.empty() ? s.name : s.title}, {"case", s.case_path},
      {"event",
          {{"volume", s.event.volume}, {"displacement", s.event.displacement}, {"of_flood", s.adaptive.of_flood}}},
      {"estimator", info_of(s.estimator).name}, {"realisations", e.n_made}, {"solved", e.counts.solved},
      {"slid_as_drawn", e.counts.slid_as_drawn}, {"failed", e.counts.failed}, {"rule_met", e.rule_met},
      {"confidence", s.confidence}, {"digits", digits_of_study(study)}};
  add_events(study, rows, e, json);
  json["sensitivities"] = Json::array();
  const bool at_random = !info_of(s.estimator).adaptive;
  for (const Sensitivity& x : e.sensitivities)
    json["sensitivities"].push_back({{"input", x.input}, {"with_slide", at_random ? or_null(x.with_slide) : Json()},
        {"with_height", at_random ? or_null(x.with_height) : Json()}});
  json["faults"] = Json::array();
  for (const FaultCount& fault : e.faults)
    json["faults"].push_back({{"what", fault.what}, {"first", fault.first}, {"count", fault.n}});
  json["remarks"] = remarks_on_study(study, rows, e);
  return json.dump(2) + '\n';
}

}  // namespace terp
