// Without --force a folder with a case is refused before anything is written into it. A trigger by strength without a
// number needs two passes. The factor of safety is searched on the case without trigger, and then the case is written
// again with it. If the search is stopped, the case without trigger stays in the folder.

#include "cli/commands.hpp"
#include "import/drawing/dxf_regions.hpp"
#include "import/dstability/drawing_folder.hpp"
#include "import/dstability/read_stix.hpp"
#include "cli/import_options.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/files/files.hpp"
#include "model/bodies/csv_rows.hpp"
#include "os/say.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace terp {
namespace {

constexpr Real drawing_snap = 0.01;  // [m]: drawings have their coordinates in cm

bool is_drawing(const std::string& path)
{
  std::string end = std::filesystem::path(path).extension().string();
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end == ".dxf";
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
}

int import_drawing(const ImportCommand& command)
{
  const Real unit = command.unit.empty() ? 0.0 : dxf_unit(command.unit);
  if (!command.unit.empty() && unit == 0.0)
    refuse_import(fmt::format("there is no unit `{}` of drawings", command.unit), "Units: m, dm, cm, mm, ft, in.");
  const DxfDrawing drawing = read_dxf(command.path, unit);
  const DxfRegions regions = regions_of(drawing, drawing_snap);
  std::vector<std::string> notes = drawing.notes;
  notes.insert(notes.end(), drawing.doubts.begin(), drawing.doubts.end());
  for (const std::string& doubt : drawing.doubts) say(stderr, "warning: {}\n", printable(doubt));
  if (command.output.empty()) {
    say("{}", printable(drawing_listing(regions, notes)));
    return solved;
  }
  refuse_to_replace(command);
  write_folder(command, drawing_folder_of(regions, notes,
                            {command.path, command.cell, between_of(command), command.base, soil_kinds(command)}));
  return solved;
}

}  // namespace

int import_file(const ImportCommand& command)
try {
  if (command.print_defaults) {
    say("{}", soil_defaults_table());
    return solved;
  }
  if (command.path.empty())
    refuse_import("`terp import` needs a file", "Give a .stix or a .dxf: terp import section.stix");
  refuse_unused_options(command, is_drawing(command.path));
  if (is_drawing(command.path)) return import_drawing(command);
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
