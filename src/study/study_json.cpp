#include "study/study_json.hpp"

#include "study/adaptive.hpp"
#include "study/fragility.hpp"
#include "study/study_text.hpp"

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

Json integral_json(const std::optional<CurveIntegral>& i)
{
  if (!i) return {};
  return {{"probability", i->probability}, {"straight", {i->of_line.low, i->of_line.high}},
      {"never_falling", {i->rising.low, i->rising.high}}, {"beyond", i->beyond}};
}

/// P at all levels together is nobody's probability: a curve has its own.
void add_events(const Study& study, const Realisations& rows, const StudyEstimates& e, Json& json)
{
  if (info_of(study.settings.estimator).adaptive) {
    const auto found = replay_adaptive(study, rows);
    json["method"] = found ? Json{{"probability", found->probability}, {"cov", or_null(found->cov)},
                                 {"design_point", found->design_point}, {"influence", found->importance}}
                           : Json();
    json["remarks"] = remarks_on_adaptive(study, rows, found);
  }
  const bool one_p = study.settings.estimator != Estimator::sweep && !info_of(study.settings.estimator).adaptive &&
                     !study.settings.fragility;
  json["slide"] = one_p ? event_json(e.slide) : Json();
  json["flood"] = one_p && e.judges_flood ? event_json(e.flood) : Json();
  json["flood_after_slide"] = one_p && e.judges_flood ? event_json(e.flood_after_slide) : Json();
  if (!study.settings.fragility) return;
  const FragilityCurve curve = estimate_fragility(study, rows);
  json["load"] = study.settings.fragility->label();
  json["slide_over_levels"] = integral_json(curve.slide);
  json["flood_over_levels"] = integral_json(curve.flood);
}

}  // namespace

std::string study_json(const Study& study, const Realisations& rows)
{
  const StudyEstimates e = estimate(study, rows);
  const StudySettings& s = study.settings;
  Json json{{"title", s.title.empty() ? s.name : s.title}, {"estimator", info_of(s.estimator).name},
      {"realisations", e.n_made}, {"solved", e.counts.solved}, {"slid_as_drawn", e.counts.slid_as_drawn},
      {"failed", e.counts.failed}, {"rule_met", e.rule_met}, {"confidence", s.confidence}};
  add_events(study, rows, e, json);
  json["sensitivities"] = Json::array();
  for (const Sensitivity& x : e.sensitivities)
    json["sensitivities"].push_back(
        {{"input", x.input}, {"with_slide", or_null(x.with_slide)}, {"with_height", or_null(x.with_height)}});
  json["faults"] = Json::array();
  for (const FaultCount& fault : e.faults)
    json["faults"].push_back({{"what", fault.what}, {"first", fault.first}, {"count", fault.n}});
  if (!json.contains("remarks")) json["remarks"] = remarks_on_study(study, rows, e);
  return json.dump(2) + '\n';
}

}  // namespace terp
