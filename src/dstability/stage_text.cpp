#include "dstability/stage_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

CaseLine ramp() { return {"ramp", "10.0", "s: slow beside the vibrations of the section; nothing drains meanwhile"}; }

/// A stage that ends at rest. longest: [s].
CaseTableText stage_until_rest(const std::string& name, const std::string& comment, const char* longest)
{
  return {"[[stage]]", comment, {{"name", quoted(name), ""}, {"until", "\"at_rest\"", ""}, {"at_most", longest, "s"}}};
}

void add_sets(const std::vector<std::string>& sets, CaseTableText& stage)
{
  if (!sets.empty()) stage.lines.push_back({"set", fmt::format("{{ {} }}", fmt::join(sets, ", ")), ""});
}

/// The search for equilibrium then takes soil without any limit to its strength (docs/stability.md).
void hold(CaseTableText& stage)
{
  stage.comment += (stage.comment.empty() ? "" : ". ") +
                   std::string("The soil would not stand: its strengths are doubled until the next stage begins");
  const std::string held = "at_strength = 0.5";
  for (CaseLine& line : stage.lines)
    if (line.key == "set") return void(line.value.insert(line.value.size() - 2, ", " + held));
  add_sets({held}, stage);
}

CaseTableText analysed_stage(const StagePlan& plan, const std::string& name)
{
  CaseTableText stage = stage_until_rest(name, fmt::format("Stage {} of the file", quoted(plan.analysed)), "30.0");
  const std::vector<std::string> released{"at_strength = 1.0"};
  if (plan.first.empty()) {
    if (plan.is_held) add_sets(released, stage);
    return stage;
  }
  stage.lines.insert(stage.lines.begin() + 1, ramp());
  if (!plan.water.empty()) stage.lines.insert(stage.lines.begin() + 1, {"water", quoted(plan.water), ""});
  std::vector<std::string> sets{"\"forces.damping.local\" = 0.05"};
  sets.insert(sets.end(), plan.sets.begin(), plan.sets.end());
  if (plan.is_held) sets.insert(sets.end(), released.begin(), released.end());
  add_sets(sets, stage);
  stage.lines.push_back({"reset_displacement", "true", ""});
  return stage;
}

CaseTableText trigger_stage(const TriggerStage& trigger)
{
  CaseTableText stage = stage_until_rest(trigger.name, trigger.comment, "30.0");
  stage.lines.insert(stage.lines.begin() + 1, {"trigger", "true", "the verdict is not that of the section as it is"});
  if (!trigger.water.empty())
    stage.lines.insert(stage.lines.begin() + 2, {{"water", quoted(trigger.water), ""}, ramp()});
  add_sets(trigger.sets, stage);
  stage.lines.push_back({"reset_displacement", "true", ""});
  return stage;
}

}  // namespace

std::vector<CaseTableText> stage_tables(const StagePlan& plan)
{
  const bool is_triggered = !plan.trigger.name.empty();
  if (plan.first.empty() && !is_triggered && !plan.is_held) return {};
  std::vector<CaseTableText> tables;
  const std::string first = key_of_name(plan.first);
  std::string analysed = key_of_name(plan.analysed);
  if (!plan.first.empty()) {
    if (analysed == first) analysed += "_2";
    tables.push_back(stage_until_rest(first, fmt::format("Stage {} of the file", quoted(plan.first)), "20.0"));
    add_sets({"\"forces.damping.local\" = 0.5"}, tables.back());
  } else if (plan.is_held) {
    tables.push_back(stage_until_rest("held", "", "20.0"));
  }
  if (plan.is_held) hold(tables.back());
  tables.push_back(analysed_stage(plan, analysed));
  if (is_triggered) tables.push_back(trigger_stage(plan.trigger));
  return tables;
}

}  // namespace terp
