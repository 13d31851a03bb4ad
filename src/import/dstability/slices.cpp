// Only what the file stores is compared, each number apart; a missing one is NaN and counts as missing, not as equal.
// The comparisons are written so that NaN falls on the safe side: a total stress that is not known makes a result
// stale, a yield stress does not.

#include "import/dstability/slices.hpp"

#include "os/csv.hpp"
#include "math/errors.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/stix_parts.hpp"
#include "io/case/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace terp {
namespace {

SliceRow stored_row(const StixSlice& slice)
{
  SliceRow row{};
  for (std::size_t k = 0; k < 2; ++k) row.place[k] = std::midpoint(slice.bottom_left[k], slice.bottom_right[k]);
  const auto set = [](Real(&pair)[2], Real stored) { pair[0] = not_given, pair[1] = stored; };
  set(row.total_stress, slice.total_stress);
  set(row.pore_pressure, slice.pore_pressure);
  set(row.yield_stress, slice.yield_stress);
  set(row.su, slice.su);
  return row;
}

void compute(const StixSection& section, ResultSlices& result)
{
  for (SliceRow& row : result.rows) {
    const StixColumn column = section.column(row.place[0]);
    row.carried = column.largest_effective_stress(row.place[1]);
    if (const auto place = column.at(row.place[1])) {
      row.total_stress[0] = place->total_stress;
      row.pore_pressure[0] = place->pore_pressure;
      row.yield_stress[0] = place->yield_stress;
      row.su[0] = place->su;
    }
  }
}

/// A stored result stays in the file when the section is edited. Two of its numbers cannot be of the section that is in
/// the file now: another weight above a slice, and a yield stress that is less than what the soil has carried before.
std::string stale_by(const ResultSlices& result)
{
  std::size_t other_weight = 0, other_history = 0;
  Real most = 0.0;
  for (const SliceRow& row : result.rows) {
    const Real difference = std::abs(row.total_stress[0] - row.total_stress[1]);
    if (!(difference <= stale_total_stress)) ++other_weight;
    most = std::max(most, std::isnan(difference) ? 0.0 : difference);
    if (row.yield_stress[1] < row.carried - stale_yield_stress) ++other_history;
  }
  if (other_weight > 0)
    return fmt::format("the total stress of {} of {} slices is another, by up to {:.2f} kPa", other_weight,
        result.rows.size(), most / pa_per_kpa);
  if (other_history > 0)
    return fmt::format("the yield stress of {} of {} slices is less than the soil carried in a stage of this file",
        other_history, result.rows.size());
  return {};
}

void widen(SliceDeviation& all, Real& largest, const Real (&pair)[2], Real unit)
{
  if (std::isnan(pair[1])) return;
  ++(std::isnan(pair[0]) ? all.missing : all.compared);
  const Real difference = std::abs(pair[0] - pair[1]) / unit;
  if (difference > largest) largest = difference;
}

}  // namespace

std::vector<ResultSlices> compare_slices(const StixProject& project)
{
  std::vector<ResultSlices> results;
  for (std::size_t s = 0; s < project.scenarios.size(); ++s)
    for (std::size_t k = 0; k < project.scenarios[s].calculations.size(); ++k) {
      const StixCalculation& calculation = project.scenarios[s].calculations[k];
      if (!calculation.result || calculation.result->slices.empty()) continue;
      ResultSlices& result = results.emplace_back();
      result.scenario = s;
      result.calculation = k;
      result.name = calculation.result->name;
      for (const StixSlice& slice : calculation.result->slices) result.rows.push_back(stored_row(slice));
      try {
        compute(StixSection(project, s, calculation.stage, basis_of(calculation.kind)), result);
      } catch (const InputError& error) {
        result.trouble = error.what();
      }
      result.stale = stale_by(result);
    }
  return results;
}

std::string slices_csv(const std::vector<ResultSlices>& results)
{
  std::string text = "result,x,z,stale";
  for (const char* name : {"total_stress", "pore_pressure", "yield_stress", "su"})
    text += fmt::format(",{0}_computed,{0}_stored", name);
  text += "\n";
  for (const ResultSlices& result : results)
    for (const SliceRow& row : result.rows) {
      text += fmt::format("{},{},{},{}", plain_csv_cell(printable(result.name)), row.place[0], row.place[1],
          result.stale.empty() ? 0 : 1);
      for (const auto* pair : {&row.total_stress, &row.pore_pressure, &row.yield_stress, &row.su})
        text += fmt::format(",{},{}", (*pair)[0], (*pair)[1]);
      text += "\n";
    }
  return text;
}

SliceDeviation largest_deviation(const ResultSlices& result)
{
  SliceDeviation largest;
  for (const SliceRow& row : result.rows) {
    widen(largest, largest.total_stress, row.total_stress, 1.0);
    widen(largest, largest.pore_pressure, row.pore_pressure, 1.0);
    widen(largest, largest.yield_stress, row.yield_stress, 1.0);
    widen(largest, largest.su, row.su, std::max(std::abs(row.su[1]), 1.0));
  }
  return largest;
}

}  // namespace terp
