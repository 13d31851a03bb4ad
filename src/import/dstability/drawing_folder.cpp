// Outlines are checked before a part of them is cut out, as cutting hides their faults. The size of the cells follows
// from the part, and the tolerances of cleaning follow from the cells. Regions of one layer share a material. Pieces
// that fill up the base come first in the list of bodies: a later body covers them where both are.

#include "import/dstability/drawing_folder.hpp"

#include "import/dstability/import_doubts.hpp"
#include "import/dstability/section_layout.hpp"
#include "import/dstability/section_part.hpp"
#include "import/dstability/soil_text.hpp"
#include "import/dstability/stage_text.hpp"
#include "io/case/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace terp {
namespace {

std::string list_text(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines) text += "- " + line + "\n";
  return text.empty() ? "- nothing\n" : text;
}

CaseTableText water_table(const SectionLayout& layout)
{
  const Real level = std::round(10.0 * (std::min(layout.left, layout.right) - 0.5)) / 10.0;
  return {"[water]",
      "Not in the drawing: assumed half a metre below the lower end of the ground. Give your own (docs/water.md).",
      {{"phreatic_line", fmt::format("[[{}, {}]]", number_text(layout.low[0]), number_text(level)), "m"}}};
}

}  // namespace

CaseFolder drawing_folder_of(
    const DxfRegions& whole, const std::vector<std::string>& notes, const DrawingFolderOptions& options)
{
  check_outlines(whole.regions);
  DxfRegions drawing = whole;
  SectionPart part;
  part.between = options.between.value_or(part.between);
  part.base = options.base.value_or(part.base);
  drawing.regions = part_of(whole.regions, part);
  std::erase_if(drawing.regions, [](const DrawnRegion& r) { return r.polygon.empty(); });
  const SectionLayout layout = layout_of(drawing.regions, {}, {.cell = options.cell});
  check_cell(layout, options.cell);
  CleaningOptions cleaning = cleaning_for(layout.cell);
  cleaning.snap = drawing.snap;
  const CleanSection clean = clean_regions(drawing.regions, {}, cleaning);
  SectionText text;
  text.title = "Section of " + options.path;
  text.head = {
      fmt::format("Written by terp import from the drawing {}. A skeleton: a drawing says nothing of soils and "
                  "water. Fill in what is a default.",
          options.path),
      "Units: m, s, Pa, kg unless one stands with the number."};
  text.before = {mesh_table(layout), time_table(until_rest)};
  BodyOrder order;
  std::map<std::string, std::string> materials;  // name of a layer -> key
  for (const CleanRegion& region : clean.regions) {
    const std::string& name = drawing.regions[region.drawn].name;
    std::string& key = materials[name];
    if (key.empty()) {
      key = key_of_name(name);
      const auto uses = [&](const CaseMaterialText& known) { return known.name == key; };
      while (std::ranges::any_of(text.materials, uses)) key += "_2";
      text.materials.push_back(default_soil_text(key, name, kind_of_soil(options.kinds, name)));
    }
    order.bodies.push_back({name, key, fmt::format("Layer {} of the drawing", in_quotes(name)), {}, {}});
    order.regions.push_back(region);
  }
  put_on_top(order);
  Real filled = 0.0;
  const std::vector<CleanRegion> fills = base_fill(layout, clean.regions);
  for (const CleanRegion& fill : fills) {
    const std::string& name = drawing.regions[fill.drawn].name;
    text.bodies.push_back(
        {name + below_the_base, materials[name], "Not in the drawing: fills what is below its base", fill.polygon, {}});
    filled += signed_area(fill.polygon);
  }
  std::ranges::move(order.bodies, std::back_inserter(text.bodies));
  name_bodies(text.bodies);
  text.after = common_tables(layout);
  text.after.insert(text.after.begin(), water_table(layout));
  CaseFolder folder;
  folder.notes = doubts_of_outlines(clean, drawing.regions, fills, layout.cell);
  if (!folder.notes.empty()) text.after.push_back(doubts_table(folder.notes, {}));
  folder.files.push_back({"case.toml", text_of(text)});
  std::string report = fmt::format("# {}\n\n## Read\n\n", text.title) + list_text(notes) + list_text(drawing.notes);
  report += "\n## Geometry: what moved\n\n" + list_text(describe(clean, drawing.regions, cleaning));
  if (filled > 0.0) report += fmt::format("- {:.3f} m2 below the base were filled.\n", filled);
  report += "\n## Assumed\n\n- All soils and the water: see the comments of case.toml.\n";
  folder.files.push_back({"report.md", printable(report)});
  return folder;
}

std::string drawing_listing(const DxfRegions& drawing, const std::vector<std::string>& notes)
{
  const CleaningOptions cleaning{.snap = drawing.snap};
  const CleanSection clean = clean_regions(drawing.regions, {}, cleaning);
  std::string text = fmt::format("{:<28} {:>12} {:>8}   {}\n", "region", "area [m2]", "corners", "box [m]");
  Real sum = 0.0;
  for (std::size_t k = 0; k < drawing.regions.size(); ++k) {
    const BoundingBox box = box_around(drawing.regions[k].polygon);
    text += fmt::format("{:<28} {:>12.3f} {:>8}   {:.2f} to {:.2f}, {:.2f} to {:.2f}\n", drawing.regions[k].name,
        clean.changes[k].area, drawing.regions[k].polygon.size(), box.low[0], box.high[0], box.low[1], box.high[1]);
    sum += clean.changes[k].area;
  }
  text += fmt::format("{:<28} {:>12.3f}\n", "all", sum);
  for (const auto* lines : {&notes, &drawing.notes})
    for (const std::string& line : *lines) text += line + "\n";
  for (const std::string& line : describe(clean, drawing.regions, cleaning)) text += line + "\n";
  return text;
}

}  // namespace terp
