// Users count scenarios and stages from 1, with 0 for what was left out; from FolderOptions on they count from 0. A
// trigger without a number keeps NaN as its value, which means that a search must find it. What is wrong with an option
// or a file becomes a CaseError, in the form that other commands use.

#include "cli/import_options.hpp"

#include "math/nan.hpp"
#include "math/number_from.hpp"
#include "import/dstability/soil_defaults.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "model/bodies/csv_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

/// "strength", "water=12.5".
FolderTrigger trigger_of(const std::string& text)
{
  const std::size_t sign = std::min(text.find('='), text.size());
  const std::string word = text.substr(0, sign), number = text.substr(std::min(sign + 1, text.size()));
  FolderTrigger trigger{.kind = word == "strength" ? TriggerKind::strength
                                : word == "water"  ? TriggerKind::water
                                                   : TriggerKind::none};
  if (!text.empty() && trigger.kind == TriggerKind::none)
    refuse_import(fmt::format("there is no trigger `{}`", word), "Triggers: strength, strength=F, water, water=LEVEL.");
  if (sign == text.size()) return trigger;
  trigger.value = number_from<Real>(number).value_or(nan);
  if (!std::isfinite(trigger.value) ||
      (trigger.kind == TriggerKind::strength && !(trigger.value > 1.0 && trigger.value <= 100.0)))
    refuse_import(fmt::format("--trigger {}: `{}` is not a {}", text, number,
                      trigger.kind == TriggerKind::strength ? "factor over 1, at most 100" : "level in m"),
        "Strengths are divided by the factor: strength=1.2. Without a number it is looked for.");
  trigger.origin = "This factor was given, not looked for.";
  return trigger;
}

}  // namespace

void refuse_import(const std::string& path, const InputError& error)
{
  std::string text;
  for (const Problem& problem : error.problems())
    text += fmt::format("error: {}{}{}{}\n{}", problem.key.starts_with(path) ? "" : path + ": ", problem.key,
        problem.key.empty() ? "" : ": ", problem.what,
        problem.detail.empty() ? "" : fmt::format("  {}\n", problem.detail));
  throw CaseError(printable(text));
}

void refuse_import(const std::string& what, const std::string& cure)
{
  throw CaseError(printable(fmt::format("error: {}\n  {}\n", what, cure)));
}

std::vector<SoilKind> soil_kinds(const ImportCommand& command)
{
  if (command.soil_defaults.empty()) return read_soil_defaults("the table of terp", soil_defaults_table());
  try {
    return read_soil_defaults(command.soil_defaults, read_file(command.soil_defaults));
  } catch (const FileError& error) {
    throw CaseError(printable(fmt::format("error: {}\n", error.what())));
  }
}

std::optional<Vec<2>> between_of(const ImportCommand& command)
{
  if (command.between.empty()) return std::nullopt;
  if (!(command.between[0] < command.between[1]))
    refuse_import(fmt::format("--between goes from {:g} m to {:g} m", command.between[0], command.between[1]),
        "Give the left end first: --between -30,60.");
  return Vec<2>{command.between[0], command.between[1]};
}

FolderOptions folder_options(const StixProject& project, const ImportCommand& command)
{
  const auto n_scenarios = static_cast<int>(project.scenarios.size());
  if (command.scenario == 0 && n_scenarios > 1)
    refuse_import(fmt::format("{} has {} scenarios", command.path, n_scenarios),
        fmt::format("Choose one: --scenario 1 to {}. terp import {} lists them.", n_scenarios, command.path));
  const int scenario = std::max(command.scenario, 1);
  if (scenario > n_scenarios)
    refuse_import(fmt::format("{} has no scenario {}", command.path, scenario), fmt::format("It has {}.", n_scenarios));
  const auto n_stages = static_cast<int>(project.scenarios[scenario - 1].stages.size());
  const int stage = command.stage == 0 ? n_stages : command.stage;
  if (stage > n_stages || n_stages == 0)
    refuse_import(fmt::format("scenario {} of {} has no stage {}", scenario, command.path, std::max(stage, 1)),
        fmt::format("It has {}.", n_stages));
  FolderOptions options{.scenario = static_cast<std::size_t>(scenario - 1),
      .stage = static_cast<std::size_t>(stage - 1),
      .cell = command.cell,
      .between = between_of(command),
      .base = command.base,
      .kinds = soil_kinds(command),
      .has_films = !command.no_film,
      .face_cohesion = 1e3 * command.face_cohesion.value_or(2.0),
      .is_held = command.is_held,
      .trigger = trigger_of(command.trigger),
      .has_study = command.study,
      .river = command.river};
  if (command.strength == "design") options.basis = StixBasis::design;
  if (command.strength == "mean" || command.study) options.basis = StixBasis::mean;
  return options;
}

bool asks_for_search(const FolderTrigger& trigger)
{
  return trigger.kind == TriggerKind::strength && std::isnan(trigger.value);
}

FoundFactors factors_of(const StabilityResult& result)
{
  return {result.search.stable, result.search.failed, result.search.highest()};
}

FolderTrigger find_weakness(
    const StixProject& project, FolderOptions options, const std::string& folder, const RunOptions& run)
{
  options.trigger = {};
  write_case_folder(folder, case_folder_of(project, options));
  RunOptions search = run;
  search.path = folder + "/case.toml";
  search.output = folder + "/stability";
  const StabilityResult result = search_stability(search);
  if (result.stopped)
    throw RunError("stopped before the factor of safety was known; the case in the folder has no trigger");
  return trigger_after(factors_of(result));
}

void write_case_folder(const std::string& path, const CaseFolder& folder)
{
  make_folder(path);
  for (const bool is_case : {false, true})  // the case last: where it is, all that it names is
    for (const auto& [name, contents] : folder.files)
      if ((name == "case.toml") == is_case) write_file_atomically(path + "/" + name, contents);
}

}  // namespace terp
