// The listing for programs; a number that the file leaves empty is null.

#include "import/dstability/listing.hpp"

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const StixParameter& p)
{
  Json json{{"value", p.value}};
  if (p.is_probabilistic) json.update({{"mean", p.mean}, {"standard_deviation", p.deviation}});
  return json;
}

Json json_of(const StixFriction& f)
{
  return {{"cohesion", json_of(f.cohesion)}, {"friction", json_of(f.friction)}, {"dilatancy", json_of(f.dilatancy)}};
}

Json json_of(const StixSoil& soil)
{
  return {{"id", soil.id}, {"name", soil.name}, {"code", soil.code}, {"colour", soil.colour},
      {"unit_weight_above", soil.weight_above}, {"unit_weight_below", soil.weight_below},
      {"strength_above", word_of(soil.above)}, {"strength_below", word_of(soil.below)},
      {"advanced", json_of(soil.advanced)}, {"classic", json_of(soil.classic)},
      {"shansep", {{"S", json_of(soil.ratio)}, {"m", json_of(soil.exponent)}}}, {"su_table", soil.su_table.rows},
      {"sigma_tau_table", soil.sigma_tau_table.rows}};
}

Json json_of(const StixCalculation& c, const std::string& verdict)
{
  Json json{{"label", c.label}, {"stage", c.stage + 1}, {"method", c.method}, {"kind", c.kind_word},
      {"model_factor", c.model_factor}, {"result", nullptr}};
  if (!c.result) return json;
  json["result"] = {{"name", c.result->name}, {"verdict", verdict}, {"slices", c.result->slices.size()}};
  if (c.result->is_reliability)
    json["result"].update(
        {{"reliability_index", c.result->reliability_index}, {"failure_probability", c.result->failure_probability}});
  else
    json["result"]["factor_of_safety"] = c.result->factor_of_safety;
  return json;
}

Json json_of(const StixStage& stage)
{
  Json layers = Json::array();
  for (const StixLayer& layer : stage.layers)
    layers.push_back({{"id", layer.id}, {"label", layer.label}, {"corners", layer.outline.size()},
        {"soil", layer.soil ? Json(*layer.soil) : Json(nullptr)}});
  return {{"label", stage.label}, {"layers", layers},
      {"water", stage.water.is_mesh    ? "mesh"
                : stage.water.phreatic ? "lines"
                                       : "none"},
      {"excavations", stage.excavations.size()}, {"uniform_loads", stage.loads.size()},
      {"state_points", stage.state_points.size()}, {"state_lines", stage.state_lines.size()}};
}

}  // namespace

std::string listing_json(const StixProject& project, const StixVerdict& verdict)
{
  Json json{{"path", project.path}, {"application", project.application}, {"content_version", project.content_version},
      {"scenarios", Json::array()}, {"soils", Json::array()}, {"remarks", Json::array()}};
  for (std::size_t s = 0; s < project.scenarios.size(); ++s) {
    const StixScenario& scenario = project.scenarios[s];
    Json stages = Json::array(), calculations = Json::array();
    for (const StixStage& stage : scenario.stages) stages.push_back(json_of(stage));
    for (std::size_t k = 0; k < scenario.calculations.size(); ++k)
      calculations.push_back(
          json_of(scenario.calculations[k], scenario.calculations[k].result ? verdict(s, k) : std::string()));
    json["scenarios"].push_back({{"label", scenario.label}, {"stages", stages}, {"calculations", calculations}});
  }
  for (const StixSoil& soil : project.soils) json["soils"].push_back(json_of(soil));
  for (const StixRemark& remark : project.remarks)
    json["remarks"].push_back({{"where", remark.where}, {"what", remark.what}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace terp
