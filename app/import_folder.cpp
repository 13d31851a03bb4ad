// terp import of drawings, and into a case folder.

#include "commands.hpp"
#include "drawing/dxf_regions.hpp"
#include "dstability/case_folder.hpp"
#include "dstability/drawing_folder.hpp"
#include "dstability/read_stix.hpp"
#include "import_checks.hpp"
#include "input/case_file.hpp"
#include "input/printable.hpp"
#include "output/files.hpp"
#include "points/csv_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

namespace terp {
namespace {

constexpr Real drawing_snap = 0.01;  // [m]: drawings have their coordinates in cm

bool is_drawing(const std::string& path)
{
  std::string end = std::filesystem::path(path).extension().string();
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end == ".dxf";
}

[[noreturn]] void refuse(const std::string& path, const InputError& error)
{
  std::string text;
  for (const Problem& problem : error.problems())
    text += fmt::format("error: {}{}: {}\n{}", problem.key.starts_with(path) ? "" : path + ": ", problem.key,
        problem.what, problem.detail.empty() ? "" : fmt::format("  {}\n", problem.detail));
  throw CaseError(printable(text));
}

[[noreturn]] void refuse(const std::string& what, const std::string& cure)
{
  throw CaseError(printable(fmt::format("error: {}\n  {}\n", what, cure)));
}

std::vector<SoilKind> soil_kinds(const ImportCommand& command)
{
  if (command.soil_defaults.empty()) return read_soil_defaults("the table of terp", soil_defaults_table());
  try {
    return read_soil_defaults(command.soil_defaults, text_of_csv(command.soil_defaults, "the table of soil defaults"));
  } catch (const CsvError& error) {
    throw CaseError(printable(fmt::format("error: {}\n", error.what())));
  }
}

/// A folder that is there may hold another case, changed by hand.
void write_folder(const ImportCommand& command, const CaseFolder& folder)
{
  const std::string case_path = command.output + "/case.toml";
  if (std::filesystem::exists(case_path) && !command.force)
    refuse(fmt::format("{} is there already", case_path), "Choose another folder: -o FOLDER. --force replaces it.");
  make_folder(command.output);
  for (const auto& [name, contents] : folder.files) write_file_atomically(command.output + "/" + name, contents);
  for (const std::string& note : folder.notes) fmt::print(stderr, "warning: {}\n", printable(note));
  fmt::print("case in {}; what was assumed, moved and left out: {}/report.md\nNext: terp check {}\n", case_path,
      command.output, case_path);
}

std::optional<Vec<2>> between_of(const ImportCommand& command)
{
  if (command.between.empty()) return std::nullopt;
  if (!(command.between[0] < command.between[1]))
    refuse(fmt::format("--between goes from {:g} m to {:g} m", command.between[0], command.between[1]),
        "Give the left end first: --between -30,60.");
  return Vec<2>{command.between[0], command.between[1]};
}

int import_drawing(const ImportCommand& command)
{
  const Real unit = command.unit.empty() ? 0.0 : dxf_unit(command.unit);
  if (!command.unit.empty() && unit == 0.0)
    refuse(fmt::format("there is no unit `{}` of drawings", command.unit), "Units: m, dm, cm, mm, ft, in.");
  const DxfDrawing drawing = read_dxf(command.path, unit);
  const DxfRegions regions = regions_of(drawing, drawing_snap);
  if (command.output.empty()) {
    fmt::print("{}", printable(drawing_listing(regions, drawing.notes)));
    return solved;
  }
  write_folder(command, drawing_folder_of(regions, drawing.notes,
                            {command.path, command.cell, between_of(command), command.base, soil_kinds(command)}));
  return solved;
}

/// Numbers as the list has them, from 1. Left out: the only scenario, its last stage.
FolderOptions folder_options(const StixProject& project, const ImportCommand& command)
{
  const auto n_scenarios = static_cast<int>(project.scenarios.size());
  if (command.scenario == 0 && n_scenarios > 1)
    refuse(fmt::format("{} has {} scenarios", command.path, n_scenarios),
        fmt::format("Choose one: --scenario 1 to {}. terp import {} lists them.", n_scenarios, command.path));
  const int scenario = std::max(command.scenario, 1);
  if (scenario > n_scenarios)
    refuse(fmt::format("{} has no scenario {}", command.path, scenario), fmt::format("It has {}.", n_scenarios));
  const auto n_stages = static_cast<int>(project.scenarios[scenario - 1].stages.size());
  const int stage = command.stage == 0 ? n_stages : command.stage;
  if (stage > n_stages || n_stages == 0)
    refuse(fmt::format("scenario {} of {} has no stage {}", scenario, command.path, std::max(stage, 1)),
        fmt::format("It has {}.", n_stages));
  FolderOptions options{.scenario = static_cast<std::size_t>(scenario - 1),
      .stage = static_cast<std::size_t>(stage - 1),
      .cell = command.cell,
      .between = between_of(command),
      .base = command.base,
      .kinds = soil_kinds(command)};
  if (command.strength == "design") options.basis = StixBasis::design;
  if (command.strength == "mean") options.basis = StixBasis::mean;
  return options;
}

}  // namespace

int import_file(const ImportCommand& command)
try {
  if (command.print_defaults) {
    fmt::print("{}", soil_defaults_table());
    return solved;
  }
  if (command.path.empty()) refuse("`terp import` needs a file", "Give a .stix or a .dxf: terp import section.stix");
  refuse_unused_options(command, is_drawing(command.path));
  if (is_drawing(command.path)) return import_drawing(command);
  if (command.output.empty()) return import_stix(command);
  const StixProject project = read_stix(command.path);
  write_folder(command, case_folder_of(project, folder_options(project, command)));
  return solved;
} catch (const InputError& error) {
  refuse(command.path, error);
}

}  // namespace terp
