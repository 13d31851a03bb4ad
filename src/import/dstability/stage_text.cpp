// A case gets stages only if it has an earlier stage, a trigger, or soil that is held at first. An earlier stage comes
// to rest with strong damping. The next one then has weak damping, and its displacements count from zero. Soil that is
// held has the water and loads of the analysed stage before it is released: what slides then slides in the water whose
// strengths it has.

#include "import/dstability/stage_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace terp {
namespace {

CaseLine ramp() { return {"ramp", "10.0", "s: slow beside the vibrations of the section; nothing drains meanwhile"}; }

/// longest: [s].
CaseTableText stage_until(const std::string& end, const std::string& name, const std::string& comment, Real longest)
{
  return {"[[stage]]", comment,
      {{"name", in_quotes(name), ""}, {"until", end, ""}, {"at_most", fmt::format("{:.1f}", longest), "s"}}};
}

void add_sets(const std::vector<std::string>& sets, CaseTableText& stage)
{
  if (!sets.empty()) stage.lines.push_back({"set", fmt::format("{{ {} }}", fmt::join(sets, ", ")), ""});
}

CaseTableText analysed_stage(const StagePlan& plan, const std::string& name)
{
  CaseTableText stage = stage_until(last_end(plan.has_flood && plan.trigger.name.empty()), name,
      fmt::format("Stage {} of the file", in_quotes(plan.analysed)), plan.longest);
  if (plan.first.empty()) return stage;
  stage.lines.insert(stage.lines.begin() + 1, ramp());
  if (!plan.water.empty()) stage.lines.insert(stage.lines.begin() + 1, {"water", in_quotes(plan.water), ""});
  std::vector<std::string> sets{"\"forces.damping.local\" = 0.05"};
  sets.insert(sets.end(), plan.sets.begin(), plan.sets.end());
  add_sets(sets, stage);
  stage.lines.push_back({"reset_displacement", "true", ""});
  return stage;
}

/// The search for equilibrium takes soil that is held without any limit to its strength (docs/stability.md).
CaseTableText rise_stage(const StagePlan& plan, const std::string& name)
{
  CaseTableText stage{"[[stage]]",
      fmt::format("Water and loads of stage {} of the file. The soil would not stand: its strengths are doubled",
          in_quotes(plan.analysed)),
      {{"name", in_quotes(name), ""}}};
  if (!plan.water.empty()) stage.lines.push_back({"water", in_quotes(plan.water), ""});
  if (!plan.first.empty()) stage.lines.push_back({"ramp", "8.0", "s"});
  stage.lines.push_back({"duration", "12.0", "s"});
  std::vector<std::string> sets{"\"forces.damping.local\" = 0.5", "at_strength = 0.5"};
  sets.insert(sets.end(), plan.sets.begin(), plan.sets.end());
  add_sets(sets, stage);
  return stage;
}

CaseTableText release_stage(const StagePlan& plan, const std::string& name)
{
  CaseTableText stage = stage_until(last_end(plan.has_flood && plan.trigger.name.empty()), name,
      "Strengths go from twice those of the file to those of the file. at_strength where it fails is its factor",
      plan.longest + 12.0);
  stage.lines.insert(stage.lines.begin() + 1, {"ramp", "12.0", "s"});
  add_sets({"\"forces.damping.local\" = 0.05", "at_strength = 1.0"}, stage);
  stage.lines.push_back({"reset_displacement", "true", ""});
  return stage;
}

CaseTableText trigger_stage(const StagePlan& plan, const std::string& name)
{
  const TriggerStage& trigger = plan.trigger;
  CaseTableText stage = stage_until(last_end(plan.has_flood), name, trigger.comment, plan.longest);
  stage.lines.insert(stage.lines.begin() + 1, {"trigger", "true", "the verdict is not that of the section as it is"});
  if (!trigger.water.empty())
    stage.lines.insert(stage.lines.begin() + 2, {{"water", in_quotes(trigger.water), ""}, ramp()});
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
  std::set<std::string> used;
  const auto own_name = [&](const std::string& name) {
    std::string own = name;
    for (int k = 2; !used.insert(own).second; ++k) own = fmt::format("{}_{}", name, k);
    return own;
  };
  if (plan.is_held) {
    tables.push_back(rise_stage(plan, own_name("rise")));
    tables.push_back(release_stage(plan, own_name("release")));
  } else {
    if (!plan.first.empty()) {
      tables.push_back(stage_until(until_rest, own_name(key_of_name(plan.first, "stage")),
          fmt::format("Stage {} of the file", in_quotes(plan.first)), 20.0));
      add_sets({"\"forces.damping.local\" = 0.5"}, tables.back());
    }
    tables.push_back(analysed_stage(plan, own_name(key_of_name(plan.analysed, "stage"))));
  }
  if (is_triggered) tables.push_back(trigger_stage(plan, own_name(plan.trigger.name)));
  return tables;
}

}  // namespace terp
