// Only what can be compared with the case becomes a key. A factor of safety needs the strengths of the case. Strengths
// at the slices need these, and a result of the section as it is. All other slip planes are kept as lines, as they
// still show where the other program found a mechanism.

#include "import/dstability/reference_text.hpp"

#include "import/dstability/slices.hpp"
#include "import/dstability/stix_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

const ResultSlices* slices_of(const std::vector<ResultSlices>& all, std::size_t scenario, std::size_t calculation)
{
  const auto found = std::ranges::find_if(
      all, [&](const ResultSlices& of) { return of.scenario == scenario && of.calculation == calculation; });
  return found == all.end() ? nullptr : &*found;
}

/// Middle of the foot of each slice with its stored strength [m, m, Pa], to the millimetre and the pascal.
std::vector<std::vector<Real>> slice_strengths(const ResultSlices& slices)
{
  std::vector<std::vector<Real>> rows;
  for (const SliceRow& row : slices.rows)
    if (row.su[1] > 0.5 && std::isfinite(row.su[1]))
      rows.push_back(
          {std::round(row.place[0] * 1e3) / 1e3, std::round(row.place[1] * 1e3) / 1e3, std::round(row.su[1])});
  return rows;
}

std::string name_of(const StixCalculation& calculation)
{
  return calculation.label.empty() ? calculation.result->name : calculation.label;
}

}  // namespace

std::vector<CaseTableText> reference_texts(
    const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis)
{
  const std::vector<ResultSlices> all = compare_slices(project);
  std::vector<CaseTableText> tables;
  const std::vector<StixCalculation>& calculations = project.scenarios[scenario].calculations;
  for (std::size_t k = 0; k < calculations.size(); ++k) {
    const StixCalculation& calculation = calculations[k];
    const auto& result = calculation.result;
    if (calculation.stage != stage || !result || result->slip_plane.size() < 2) continue;
    const ResultSlices* slices = slices_of(all, scenario, k);
    const SliceState state = slices != nullptr ? slices->state : SliceState::fits;
    const std::string_view strengths = strengths_of(calculation.kind);
    const bool is_alike = strengths == strengths_of(basis);
    const std::string name = name_of(calculation) + (is_alike ? "" : fmt::format(" ({} strengths)", strengths)) +
                             (state == SliceState::other_section        ? " (of another section)"
                                 : state == SliceState::other_strengths ? " (of other strengths)"
                                                                        : "");
    std::vector<CaseLine> lines{{"name", in_quotes(name), ""}, {"method", in_quotes(calculation.method), ""}};
    if (result->factor_of_safety > 0.0 && std::isfinite(result->factor_of_safety)) {
      const std::string factor = fmt::format("{:.4f}", result->factor_of_safety);
      if (is_alike)
        lines.push_back({"factor_of_safety", factor, ""});
      else
        lines.back().comment = fmt::format("factor {} with its {} strengths", factor, strengths);
    }
    lines.push_back({"line", places_text(result->slip_plane, 2, 19), ""});
    if (slices != nullptr && state == SliceState::fits && is_alike)
      if (const auto rows = slice_strengths(*slices); !rows.empty())
        lines.push_back({"su", list_text(rows, 2, 19), ""});
    tables.push_back({"[[reference.slip_planes]]",
        tables.empty()
            ? "Slip planes of D-Stability, drawn over the slip surface on the report page, with the undrained\n"
              "strength at their slices [x, y, Pa], which `terp check` compares"
            : "",
        std::move(lines)});
  }
  return tables;
}

std::vector<std::string> slices_in_words(const StixProject& project, std::size_t scenario, std::size_t stage)
{
  std::vector<std::string> sentences;
  for (const ResultSlices& slices : compare_slices(project)) {
    const StixCalculation& calculation = project.scenarios[slices.scenario].calculations[slices.calculation];
    if (slices.scenario != scenario || calculation.stage != stage) continue;
    std::string text = fmt::format("{}, {} slices: ", name_of(calculation), slices.rows.size());
    if (!slices.trouble.empty())
      text += slices.trouble;
    else if (slices.state != SliceState::fits)
      text += fmt::format("{}, {}.", words_of(slices.state), slices.why);
    else {
      const SliceDeviation most = largest_deviation(slices);
      text += fmt::format(
          "largest differences: total stress {:.3f} kPa, pore pressure {:.3f} kPa, yield stress {:.3f} "
          "kPa, undrained strength {:.3f} %{}.",
          most.total_stress / pa_per_kpa, most.pore_pressure / pa_per_kpa, most.yield_stress / pa_per_kpa,
          100.0 * most.su, most.missing > 0 ? fmt::format("; {} numbers have no computed one", most.missing) : "");
    }
    sentences.push_back(std::move(text));
  }
  return sentences;
}

}  // namespace terp
