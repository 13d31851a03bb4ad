// Only what the file stores is compared, each number apart; a missing one is NaN and counts as missing, not as equal.
// The comparisons are written so that NaN falls on the safe side: a total stress that is not known makes a result one
// of another section, a strength does not.
//
// The limits come from 411 results of public files. Those that fit have at most 2.2 % of slices off and a strength
// along the slip plane within 1.04 %; the next ones have 5 % and 2.5 %.

#include "import/dstability/slices.hpp"

#include "os/csv.hpp"
#include "math/errors.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/stix_parts.hpp"
#include "io/case/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace terp {
namespace {

constexpr Real other_total_stress = 100.0, other_total_part = 0.01;  // of a slice of another section [Pa, -],
constexpr Real other_pressure = 500.0, other_pressure_part = 0.02;   // its pore pressure beside the total stress,
constexpr Real most_other = 0.05;                                    // and the share of them that still fits
constexpr Real other_resistance = 0.02;                              // of strength along the slip plane [-]
constexpr Real other_strength = 0.05, most_of_other_strength = 0.1;  // of a slice, and the share that still fits [-]

SliceRow stored_row(const StixSlice& slice)
{
  SliceRow row{};
  for (std::size_t k = 0; k < 2; ++k) row.place[k] = std::midpoint(slice.bottom_left[k], slice.bottom_right[k]);
  const auto set = [](Real(&pair)[2], Real stored) { pair[0] = not_given, pair[1] = stored; };
  set(row.total_stress, slice.total_stress);
  set(row.pore_pressure, slice.pore_pressure);
  set(row.yield_stress, slice.yield_stress);
  set(row.su, slice.su);
  set(row.strength, slice.strength);
  row.length = std::hypot(slice.bottom_right[0] - slice.bottom_left[0], slice.bottom_right[1] - slice.bottom_left[1]);
  return row;
}

void compute(const StixSection& section, const std::vector<StixSlice>& stored, ResultSlices& result)
{
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    SliceRow& row = result.rows[k];
    const auto place = section.column(row.place[0]).at(row.place[1]);
    if (!place) continue;
    row.total_stress[0] = place->total_stress;
    row.pore_pressure[0] = place->pore_pressure;
    row.yield_stress[0] = place->yield_stress;
    row.su[0] = place->su;
    const Real friction = std::tan(place->friction * std::numbers::pi / 180.0);
    row.strength[0] = std::isnan(place->su) ? place->cohesion + stored[k].normal_stress * friction : place->su;
  }
}

bool is_of_other_section(const SliceRow& row)
{
  const auto [sigma, stored] = row.total_stress;
  const auto [u, stored_u] = row.pore_pressure;
  return !(std::abs(sigma - stored) <= std::max(other_total_stress, other_total_part * std::abs(stored))) ||
         std::abs(u - stored_u) > std::max(other_pressure, other_pressure_part * std::abs(stored));
}

void judge(ResultSlices& result)
{
  const auto n_rows = static_cast<Real>(result.rows.size());
  const auto n_other = std::ranges::count_if(result.rows, is_of_other_section);
  const bool leaves_soil =
      std::ranges::any_of(result.rows, [](const SliceRow& row) { return std::isnan(row.total_stress[0]); });
  if (leaves_soil || static_cast<Real>(n_other) >= most_other * n_rows) {
    result.state = SliceState::other_section;
    result.why = fmt::format("{} of {} slices have another total stress or pore pressure", n_other, result.rows.size());
    return;
  }
  Real computed = 0.0, stored = 0.0;
  std::size_t n_weaker = 0;
  for (const SliceRow& row : result.rows) {
    const auto [here, there] = row.strength;
    if (!(there > 0.0) || std::isnan(here)) continue;
    computed += here * row.length, stored += there * row.length;
    if (std::abs(here - there) > other_strength * there) ++n_weaker;
  }
  if (stored > 0.0) result.resistance = computed / stored;
  if (!(std::abs(result.resistance - 1.0) > other_resistance) &&
      static_cast<Real>(n_weaker) <= most_of_other_strength * n_rows)
    return;
  result.state = SliceState::other_strengths;
  result.why = fmt::format(
      "the strength along its slip plane is {:.2f} times the stored one, and differs at {} of {} "
      "slices: its factor is of other strengths",
      result.resistance, n_weaker, result.rows.size());
}

void widen(SliceDeviation& all, Real& largest, const Real (&pair)[2], Real unit)
{
  if (std::isnan(pair[1])) return;
  ++(std::isnan(pair[0]) ? all.missing : all.compared);
  const Real difference = std::abs(pair[0] - pair[1]) / unit;
  if (difference > largest) largest = difference;
}

}  // namespace

const char* words_of(SliceState state)
{
  switch (state) {
    case SliceState::fits: return "fits";
    case SliceState::other_strengths: return "strengths differ";
    case SliceState::other_section: break;
  }
  return "other section";
}

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
        compute(
            StixSection(project, s, calculation.stage, basis_of(calculation.kind)), calculation.result->slices, result);
      } catch (const InputError& error) {
        result.trouble = error.what();
      }
      judge(result);
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
          result.state == SliceState::other_section ? 1 : 0);
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
