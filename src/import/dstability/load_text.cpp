// A load counts as the same in two stages if its ends and its magnitude are equal. Then it acts from the start. Every
// other load exists from the start with zero pressure, and the analysed stage sets its pressure by name. Therefore each
// load needs a name that no other load has.

#include "import/dstability/load_text.hpp"

#include "import/dstability/soil_text.hpp"
#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace terp {
namespace {

std::vector<Sentence> remarks_on(const StixUniformLoad& load, const std::string& label)
{
  std::vector<Sentence> remarks;
  if (load.spread != 0.0) remarks.push_back(filled<reported_texts::load_spread>(label, load.spread));
  if (std::ranges::any_of(load.consolidation, [](const auto& entry) { return entry.second > 0.0; }))
    remarks.push_back(filled<reported_texts::load_consolidation>(label));
  return remarks;
}

CaseTableText table_of(const StixUniformLoad& load, const std::string& label, Vec<2> ends, bool always)
{
  return {"[[load]]", fmt::format("Uniform load of {:g} kPa, spread {:g} degrees", load.magnitude / 1e3, load.spread),
      {{"name", in_quotes(label), ""}, {"from", number_text(ends[0]), "m"}, {"to", number_text(ends[1]), "m"},
          {"pressure", always ? in_quotes(kilo_text(load.magnitude, "kPa")) : "0.0",
              always ? "" : "put on in the last stage"}}};
}

bool has_excess(const StixLayerLoad& load)
{
  return std::ranges::any_of(load.consolidation, [](const auto& entry) { return entry.second < 100.0; });
}

}  // namespace

LoadTexts load_texts(const StixStage& stage, const StixStage* first, const SectionLayout& layout)
{
  LoadTexts texts;
  std::set<std::string> labels;
  for (const StixUniformLoad& load : stage.loads) {
    const Vec<2> ends{std::max(std::min(load.start, load.end), layout.low[0]),
        std::min(std::max(load.start, load.end), layout.high[0])};
    const std::string wanted = key_of_name(load.label, "load");
    std::string label = wanted;
    for (int k = 2; !labels.insert(label).second; ++k) label = fmt::format("{}_{}", wanted, k);
    if (!(ends[1] > ends[0]) || !(load.magnitude > 0.0)) {
      texts.left_out.push_back(filled<reported_texts::load_of_no_size>(label));
      continue;
    }
    const auto is_same = [&](const StixUniformLoad& other) {
      return other.start == load.start && other.end == load.end && other.magnitude == load.magnitude;
    };
    const bool always = first == nullptr || std::ranges::any_of(first->loads, is_same);
    texts.tables.push_back(table_of(load, label, ends, always));
    if (!always) texts.sets.push_back(fmt::format("\"load.{}.pressure\" = {:g}", label, load.magnitude));
    std::ranges::move(remarks_on(load, label), std::back_inserter(texts.assumed));
  }
  if (std::ranges::any_of(stage.layer_loads, has_excess))
    texts.left_out.push_back(filled<reported_texts::layers_as_loads>());
  return texts;
}

}  // namespace terp
