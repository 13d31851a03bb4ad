#include "dstability/reference_text.hpp"

#include "dstability/slices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {

std::vector<CaseTableText> reference_texts(const StixProject& project, std::size_t scenario, std::size_t stage)
{
  const std::vector<ResultSlices> slices = compare_slices(project);
  const auto is_stale = [&](std::size_t calculation) {
    return std::ranges::any_of(slices, [&](const ResultSlices& of) {
      return of.scenario == scenario && of.calculation == calculation && !of.stale.empty();
    });
  };
  std::vector<CaseTableText> tables;
  const std::vector<StixCalculation>& calculations = project.scenarios[scenario].calculations;
  for (std::size_t k = 0; k < calculations.size(); ++k) {
    const StixCalculation& calculation = calculations[k];
    const auto& result = calculation.result;
    if (calculation.stage != stage || !result || result->slip_plane.size() < 2) continue;
    const std::string name = (calculation.label.empty() ? result->name : calculation.label) +
                             (is_stale(k) ? " (stale: of another section)" : "");
    std::vector<CaseLine> lines{{"name", quoted(name), ""}, {"method", quoted(calculation.method), ""}};
    if (result->factor_of_safety > 0.0 && std::isfinite(result->factor_of_safety))
      lines.push_back({"factor_of_safety", fmt::format("{:.4f}", result->factor_of_safety), ""});
    lines.push_back({"line", places_text(result->slip_plane, 2, 19), ""});
    tables.push_back({"[[reference.slip_planes]]",
        tables.empty() ? "Slip planes of D-Stability, drawn over the slip surface on the report page" : "",
        std::move(lines)});
  }
  return tables;
}

}  // namespace terp
