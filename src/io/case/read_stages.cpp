// The tree of the file takes the values that a stage sets, as it takes those of --set, and is read again. The nodes
// keep their places, so that a message about a value points at the stage that sets it.

#include "io/case/reader.hpp"

#include "io/case/case_file.hpp"
#include "io/case/case_record.hpp"
#include "io/case/check_case.hpp"
#include "io/case/key_text.hpp"
#include "io/case/library_keys.hpp"
#include "io/case/overrides.hpp"
#include "io/case/render.hpp"
#include "run/loop/stages.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

/// The warning that no body is of a material, which holds of the stages together.
bool is_of_use(const Problem& warning) { return warning.topic == "body.material"; }

/// Drops it for materials that a body is of in some stage.
void drop_used_materials(const std::vector<StageCase>& stages, std::vector<Problem>& warnings)
{
  std::erase_if(warnings, [&](const Problem& warning) {
    const auto uses = [&](const BodyCase& body) { return join_path("material", body.material) == warning.key; };
    const auto has_use = [&](const StageCase& stage) { return std::ranges::any_of(stage.changed->bodies, uses); };
    return is_of_use(warning) && std::ranges::any_of(stages, has_use);
  });
}

/// "load[0].pressure" -> "load[].pressure", "material.clay.density" -> "material.NAME.density".
std::string pattern_of(const std::vector<std::string>& parts)
{
  std::string pattern;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const bool is_entry =
        parts[k].starts_with('[') || (k > 0 && parts[k].find_first_not_of("0123456789") == std::string::npos);
    const bool is_name = k == 1 && (parts[0] == "material" || parts[0] == "boundary");
    if (is_entry)
      pattern += "[]";
    else
      pattern += (k == 0 ? "" : ".") + (is_name ? (parts[0] == "material" ? "NAME" : "SIDE") : parts[k]);
  }
  return pattern;
}

std::string changeable_keys()
{
  std::vector<std::string> names;
  for (const KeyInfo& key : all_keys())
    if (key.in_stage) names.push_back(key.path);
  names.emplace_back("the parameters of [material.NAME]");
  return plain_list(names);
}

/// Of a key of a material; in a soil of two parts it stands below the name of a part.
std::string parameter_of(const std::vector<std::string>& parts)
{
  if (parts[0] != "material" || parts.size() < 3) return "";
  return parts.size() > 3 && (parts[2] == "below" || parts[2] == "above") ? parts[3] : parts[2];
}

/// True for keys that are not known either: reading says so better.
bool may_change(const std::vector<std::string>& parts)
{
  if (parts[0] == "material" && parts.size() > 2) {
    std::string rest = parameter_of(parts);
    if (rest == parts[2] && parts.size() > 3) rest += '.' + parts[3];
    const KeyInfo* key = find_key("material.NAME." + rest);
    return key == nullptr ? find_section("material.NAME." + rest) == nullptr : key->in_stage;
  }
  const std::string pattern = pattern_of(parts);
  if (const KeyInfo* key = find_key(pattern)) return key->in_stage;
  const auto is_section = [&](const SectionInfo& section) {
    return section.path == pattern || section.path == pattern + "[]" || section.path.starts_with(pattern + '.');
  };
  return std::ranges::none_of(all_sections(), is_section);
}

/// The parameters that vary from point to point must be the same ones in all stages.
void check_fields_of_laws(const Case& before, const Case& now, std::vector<Problem>& problems)
{
  for (std::size_t m = 0; m < std::min(before.materials.size(), now.materials.size()); ++m) {
    const auto same = [](const ParameterField& a, const ParameterField& b) { return a.parameter == b.parameter; };
    if (!std::ranges::equal(before.materials[m].fields, now.materials[m].fields, same))
      problems.push_back({join_path("material", now.materials[m].name),
          "a parameter cannot begin or cease to vary from point to point in a stage",
          "Its points have values of their own from t = 0 on, or never.", "stage.set", true});
  }
}

/// Soil that becomes undrained in the very stage in which the water changes: a river that rises would not weaken it.
void doubt_undrained_rise(
    const Case& values, std::size_t stage, const Case& before, const Case& now, std::vector<Problem>& warnings)
{
  const StageWater water = water_of_stage(values, stage);
  if (!water.given || water.from == water.to) return;
  for (std::size_t m = 0; m < std::min(before.materials.size(), now.materials.size()); ++m) {
    const MaterialCase& soil = now.materials[m];
    if (soil.drainage != Drainage::undrained_effective || before.materials[m].drainage == soil.drainage) continue;
    warnings.push_back({fmt::format("stage[{}].set", stage),
        fmt::format("`{}` becomes undrained in the stage in which the water changes", soil.called()),
        "Its pore pressure follows its total stress from then on, and not the lines: a river that rises hardly weakens "
        "it.\nChange the water in a stage before.",
        "stage.set"});
  }
}

/// Soil begins with the strength of the first stage: over a ramp it could not grow weaker there.
void check_first_strength(const Case& values, const Case& first, std::vector<Problem>& problems)
{
  if (!(values.stages[0].ramp > 0.0) || first.at_strength <= values.at_strength) return;
  problems.push_back({"stage[0].set", "soil cannot grow weaker over the ramp of the first stage",
      fmt::format("Got at_strength = {:g} and ramp = {:g} s: soil begins with the strength of the first stage. Give "
                  "at_strength = {:g} in\na stage after this one; to begin with it, at the top of the case.",
          first.at_strength, values.stages[0].ramp, first.at_strength),
      "at_strength", true, {"stage[0].ramp"}});
}

void set_values(const std::string& path, const Node& set, Node& root, std::vector<Problem>& problems)
{
  const Node values = set;  // the list of stages is a part of the tree that changes
  for (const auto& [key, value] : leaves_of(values)) {
    const auto refuse = [&, key = key](const std::vector<std::string>& parts) -> std::optional<Problem> {
      const bool is_list = parts[0] == "load" || parts[0] == "body";
      const bool by_number = parts.size() > 1 && parts[1].find_first_not_of("[]0123456789") == std::string::npos;
      if (is_list && parts.size() > 1 && !by_number)
        return Problem{path + ".set", fmt::format("this case has no `{}.{}`", parts[0], parts[1]),
            "Give the number of the entry, counted from 0, or its `name`.", "stage.set"};
      if (parameter_of(parts) == "yield_stress")
        return Problem{path + ".set", fmt::format("a stage cannot change `{}`", key),
            "A yield stress is that of the start. What the soil has been loaded to since then stays with it.",
            "stage.set"};
      if (may_change(parts)) return std::nullopt;
      return Problem{path + ".set", fmt::format("a stage cannot change `{}`", key),
          "These may change: " + changeable_keys() +
              ".\nMesh, points and method are those of the whole run: solve another case for another of them.",
          "stage.set"};
    };
    if (auto problem = set_in_tree(root, key, *value, path + ".set", refuse)) problems.push_back(*problem);
  }
}

/// Enters in the bodies which stages place and remove them, and whether they are there in the stage of a number,
/// counted from 1; 0: at the start.
void enter_bodies(const std::vector<StageCase>& stages, StageNumber now, std::vector<BodyCase>& bodies)
{
  const auto enter = [&](const std::vector<std::string>& names, StageNumber BodyCase::*number, StageNumber stage) {
    for (BodyCase& body : bodies)
      if (!body.name.empty() && std::ranges::find(names, body.name) != names.end()) body.*number = stage;
  };
  for (std::size_t k = 0; k < stages.size(); ++k) {
    enter(stages[k].place, &BodyCase::placed, k + 1);
    enter(stages[k].remove, &BodyCase::removed, k + 1);
  }
  for (BodyCase& body : bodies) body.is_there = body.placed <= now && body.removed > now;
}

}  // namespace

void read_stages(const Document& document, Case& values, std::vector<Problem>& warnings)
{
  Document changed = document;
  std::string keys_before = text_of_keys(document.root, values);
  const auto known = [&](const Problem& problem) {
    return std::ranges::any_of(
        warnings, [&](const Problem& w) { return w.what == problem.what && w.key == problem.key; });
  };
  for (std::size_t k = 0; k < values.stages.size(); ++k) {
    StageCase& stage = values.stages[k];
    const std::string path = fmt::format("stage[{}]", k);
    Findings findings;
    if (const Node* set = find_node(document.root, path + ".set"))
      set_values(path, *set, changed.root, findings.problems);
    Case now;
    now.name = values.name, now.folder = values.folder;
    if (findings.problems.empty()) {
      read_values(changed.root, now, findings);
      now.initial = values.initial;  // of the run, whatever water a stage brings
      check_case(changed.root, now, findings);
      check_fields_of_laws(values, now, findings.problems);
      if (k == 0) check_first_strength(values, now, findings.problems);
      check_libraries_of_stage(values, now, findings.problems);
      doubt_undrained_rise(values, k, k == 0 ? values : *values.stages[k - 1].changed, now, findings.warnings);
      check_first_calls(k == 0 ? values : *values.stages[k - 1].changed, now, k, findings.problems);
      if (stage.until != Until::end) check_what_goes_on(now, findings.warnings);
    }
    if (!findings.problems.empty()) throw CaseError(render_errors(findings.problems, changed));
    const bool sets = !stage.changes.empty();
    std::string keys_now = sets ? text_of_keys(changed.root, now) : keys_before;
    if (sets && keys_now == keys_before)
      findings.warnings.push_back({path + ".set", "`set` of this stage changes nothing",
          "All its keys have these values already. Leave it out, or give the values of this stage.", "stage.set"});
    keys_before = std::move(keys_now);
    for (const Problem& w : findings.warnings)
      if (!known(w) && !is_of_use(w) && !(stage.until != Until::end && w.key.starts_with("forces.damping")))
        warnings.push_back(w);
    turn_counter_clockwise(now.mesh);
    enter_bodies(values.stages, k + 1, now.bodies);
    now.stages.clear();
    stage.changed = std::make_shared<const Case>(std::move(now));
  }
  enter_bodies(values.stages, 0, values.bodies);
  drop_used_materials(values.stages, warnings);
}

}  // namespace terp
