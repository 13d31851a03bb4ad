// Without --force a folder with a case is refused before anything is written into it. A trigger by strength without a
// number needs two passes. The factor of safety is searched on the case without trigger, and then the case is written
// again with it. If the search is stopped, the case without trigger stays in the folder.

#include "cli/commands.hpp"
#include "import/drawing/drawn_sections.hpp"
#include "import/drawing/dxf_regions.hpp"
#include "import/drawing/ground_profile.hpp"
#include "import/dstability/drawing_folder.hpp"
#include "import/dstability/read_stix.hpp"
#include "cli/import_options.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "math/utf8.hpp"
#include "model/bodies/csv_rows.hpp"
#include "os/say.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>

namespace terp {
namespace {

constexpr Real drawing_snap = 0.01;  // [m]: drawings have their coordinates in cm

Real unit_of(const ImportCommand& command)
{
  const Real unit = command.unit.empty() ? 0.0 : dxf_unit(command.unit);
  if (!command.unit.empty() && unit == 0.0)
    refuse_import(fmt::format("there is no unit `{}` of drawings", command.unit), "Units: m, dm, cm, mm, ft, in.");
  return unit;
}

/// Of a list apart by commas, without blanks around them.
std::vector<std::string> words_of(const std::string& list)
{
  std::vector<std::string> words;
  std::istringstream parts(list);
  for (std::string word; std::getline(parts, word, ',');)
    if (!trimmed(word).empty()) words.emplace_back(trimmed(word));
  return words;
}

/// A folder that is there may hold another case, changed by hand.
void refuse_to_replace(const ImportCommand& command)
{
  const std::string case_path = command.output + "/case.toml";
  if (std::filesystem::exists(case_path) && !command.force)
    refuse_import(
        fmt::format("{} is there already", case_path), "Choose another folder: -o FOLDER. --force replaces it.");
}

void write_folder(const ImportCommand& command, const CaseFolder& folder)
{
  write_case_folder(command.output, folder);
  const std::string case_path = command.output + "/case.toml";
  for (const Sentence& note : folder.notes) say(stderr, "warning: {}\n", printable(note.en));
  say("case in {}; what was assumed, moved and left out: {}/report.md\nNext: terp check {}\n", case_path,
      command.output, case_path);
  if (command.study)
    say("      terp study check {}/study.toml\n", command.output);
  else if (std::filesystem::exists(command.output + "/study.toml"))
    say(stderr, "warning: {}/study.toml was not written now: it is of the case that was here before\n", command.output);
}

int import_regions(const ImportCommand& command, const DxfRegions& regions, std::vector<std::string> notes)
{
  for (const std::string& doubt : regions.doubts) {
    notes.push_back(doubt);
    say(stderr, "warning: {}\n", printable(doubt));
  }
  if (command.output.empty()) {
    say("{}", printable(drawing_listing(regions, notes)));
    return solved;
  }
  refuse_to_replace(command);
  write_folder(command, drawing_folder_of(regions, notes,
                            {command.path, command.cell, between_of(command), command.base, soil_kinds(command)}));
  return solved;
}

int import_drawing(const ImportCommand& command)
{
  DxfDrawing drawing = read_dxf(command.path, unit_of(command), words_of(command.layers));
  if (const auto& w = command.window; !w.empty()) {
    if (!(w[0] < w[2] && w[1] < w[3]))
      refuse_import("--window has no width or no height", "Give the lower left corner first: --window 0,-10,60,8.");
    keep_window(drawing, {{w[0], w[1]}, {w[2], w[3]}});
  }
  DxfRegions regions = regions_of(drawing, drawing_snap);
  regions.doubts.insert(regions.doubts.begin(), drawing.doubts.begin(), drawing.doubts.end());
  return import_regions(command, regions, drawing.notes);
}

DxfRegions profile_of(const ImportCommand& command)
{
  if (command.base && command.depth > 0.0)
    refuse_import("--base and --depth both say where the base lies", "Leave one of them out.");
  const DxfRegions ground = read_profile(command.path, read_file(command.path),
      {std::string(trimmed(command.layers)), unit_of(command), command.depth, command.base});
  if (command.soils.empty()) return ground;
  const std::size_t comma = std::min(command.soils.find(','), command.soils.size());
  const std::string file = command.soils.substr(0, comma);
  const std::string name = command.soils.substr(std::min(comma + 1, command.soils.size()));
  return with_soils(ground, file, read_file(file), std::string(trimmed(name)));
}

}  // namespace

int import_file(const ImportCommand& command)
try {
  if (command.print_defaults) {
    say("{}", soil_defaults_table());
    return solved;
  }
  if (command.path.empty())
    refuse_import("`terp import` needs a file", "Give a .stix, a .dxf or a .csv: terp import section.stix");
  const SectionFile kind = kind_of_section(command.path);
  refuse_unused_options(command, kind);
  refuse_options_beside_study(command);
  if (kind == SectionFile::drawing) return import_drawing(command);
  if (kind == SectionFile::profile) return import_regions(command, profile_of(command), {});
  if (command.output.empty()) return import_stix(command);
  refuse_to_replace(command);
  const StixProject project = read_stix(command.path);
  FolderOptions options = folder_options(project, command);
  if (asks_for_search(options.trigger)) {
    options.trigger = find_weakness(project, options, command.output, {});
    options.is_held = options.is_held || options.trigger.needs_hold;
  }
  write_folder(command, case_folder_of(project, options));
  return solved;
} catch (const InputError& error) {
  refuse_import(command.path, error);
}

}  // namespace terp
