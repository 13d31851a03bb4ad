// Charts over time are of the slope on the side that the first solved run of a sequence faces.

#include "page/convergence_page.hpp"

#include "page/document.hpp"

#include <algorithm>

namespace terp {
namespace {

constexpr std::size_t most_rows = 400;  // of a run; a chart is no wider

std::vector<PageColumn> over_time(const RunResults& run, std::optional<Facing> facing)
{
  const bool left = facing == Facing::left;
  std::vector<PageColumn> columns;
  for (const char* name : {"time", left ? "front_left_x" : "front_x", left ? "crest_left_x" : "crest_x",
           left ? "crest_left_y" : "crest_y", "moved_volume", "kinetic", "plastic", "damping_work"}) {
    const auto* values = run.ledger.find(name);
    if (values == nullptr) continue;
    const QuantityInfo info = describe_column(name);
    PageColumn column{name, std::string(info.label), std::string(info.unit), {}};
    const std::size_t stride = 1 + values->size() / most_rows;
    for (std::size_t k = 0; k < values->size(); k += stride) column.values.push_back((*values)[k]);
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace

Payload convergence_payload(const MeshStudy& study, const std::string& written)
{
  PageDocument page(study_json(study, written));
  for (std::size_t s = 0; s < study.sequences.size(); ++s) {
    const auto& runs = study.sequences[s].sequence.runs;
    const auto solved = std::ranges::find(runs, std::string(), &StudyRun::fault);
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (runs[k].fault.empty())
        page.data["sequences"][s]["runs"][k]["over_time"] =
            page.table(over_time(runs[k].results, solved->results.summary.values.facing));
  }
  return page.payload("convergence", written);
}

}  // namespace terp
