#include "import/dstability/folder_water.hpp"

#include "import/dstability/case_text.hpp"
#include "import/dstability/reported_texts.hpp"
#include "import/dstability/soil_text.hpp"

#include <fmt/format.h>

#include <utility>

namespace terp {

void FolderWater::add(const WaterText& water, const std::string& header, const std::string& comment,
    std::vector<CaseLine> lines, Real cell)
{
  lines.insert(lines.end(), water.lines.begin(), water.lines.end());
  tables.push_back({header, comment, lines});
  if (!water.grid_file.empty()) files.push_back({water.grid_file, water.grid});
  notes.push_back(water.on_grid ? fmt::format("{}: on a grid of {} m, as the file's water cannot be said with lines.",
                                      comment, number_text(cell))
                                : fmt::format("{}: lines; they give the pressures of the file within {:.2f} kPa.",
                                      comment, water.deviation / 1e3));
}

FolderWater water_of_stages(const StixSection& now, const StixSection& first, const SectionLayout& layout, bool staged,
    const std::string& taken)
{
  FolderWater made;
  const StixStage &stage = now.stage(), &start_stage = first.stage();
  WaterText start = staged ? water_text(first, layout, "water_start", false) : WaterText{};
  WaterText water = water_text(now, layout, "water", !start.lines.empty());
  if (water.lines.empty() && start.lines.empty()) {
    made.assumed.push_back(filled<reported_texts::all_dry>());
    return made;
  }
  const bool is_dry = water.lines.empty();
  for (auto& [text, of] : {std::pair{&start, &start_stage}, {&water, &stage}})
    if (staged && text->lines.empty()) {
      *text = water_below(layout);
      made.assumed.push_back(filled<reported_texts::water_beneath>(in_quotes(of->label)));
    }
  made.situation = staged ? key_of_name(stage.label, "stage") + "_water" : "";
  if (made.situation == taken) made.situation += "_2";
  made.phreatic = water.phreatic;
  const auto unit =
      CaseLine{"unit_weight", in_quotes(kilo_text((is_dry ? start_stage : stage).water.unit_weight, "kN/m3")), ""};
  const auto called = [](const StixStage& of) { return fmt::format("Stage {}", in_quotes(of.label)); };
  made.add(staged ? start : water, "[water]", called(staged ? start_stage : stage), {unit}, layout.cell);
  if (staged)
    made.add(water, "[[water.situation]]", called(stage), {{"name", in_quotes(made.situation), ""}}, layout.cell);
  return made;
}

}  // namespace terp
