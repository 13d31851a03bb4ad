// What a key of a slice means depends on the version of D-Stability and on the method. Here all strengths become those
// of the soil, not divided by the factor of safety. No number of a result is required: one that is missing is not a
// number. A slice without a foot is counted and left out, since it has no place.

#include "import/dstability/stix_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace terp {
namespace {

constexpr std::array<std::pair<std::string_view, StixCalculationKind>, 4> kinds{
    {{"Deterministic", StixCalculationKind::deterministic}, {"Design", StixCalculationKind::design},
        {"Mean", StixCalculationKind::mean}, {"Probabilistic", StixCalculationKind::probabilistic}}};

/// s_u: up to version 2024.01 SuOutput; from then on that is s_u over the factor of safety, and SuInput has s_u.
Real su_of(JsonCursor& slice)
{
  const bool has_input = slice.has("SuInput");
  const Real input = slice.number("SuInput"), output = slice.number("SuOutput");
  return pa_per_kpa * (has_input ? input : output);
}

/// Strength in shear. ShearStress is the strength, but that of Spencer's method and OutputShearStress, which is there
/// from version 2024.02 on instead, are the strength over the factor of safety.
Real strength_of(JsonCursor& slice, const StixResult& result)
{
  const bool has_strength = slice.has("ShearStress") && !result.name.starts_with("spencer");
  const Real stress = pa_per_kpa * slice.number(slice.has("ShearStress") ? "ShearStress" : "OutputShearStress");
  return has_strength ? stress : result.factor_of_safety * stress;
}

StixSlice read_slice(JsonCursor& from, const StixResult& result)
{
  StixSlice slice{.bottom_left = from.place_if_given("BottomLeft"), .bottom_right = from.place_if_given("BottomRight")};
  const auto stress = [&](const char* key) { return pa_per_kpa * from.number(key); };
  slice.total_stress = stress("TotalStress");
  slice.pore_pressure = stress("TotalPorePressure");
  slice.normal_stress = stress("NormalStress");
  slice.yield_stress = stress("YieldStress");
  slice.su = su_of(from);
  slice.friction = from.number("PhiInput");
  slice.strength = strength_of(from, result);
  return slice;
}

}  // namespace

void read_settings(JsonCursor& file, StixParts& parts)
{
  StixCalculation settings{.method = file.text("AnalysisType"), .kind_word = file.text("CalculationType")};
  const auto found = std::ranges::find(kinds, settings.kind_word, [](const auto& k) { return k.first; });
  settings.kind = found == kinds.end() ? StixCalculationKind::unknown : found->second;
  if (found == kinds.end()) file.remark(filled<reported_texts::unknown_calculation>(settings.kind_word));
  settings.model_factor = file.number("ModelFactorMean");
  settings.model_factor_deviation = file.number("ModelFactorStandardDeviation");
  parts.settings.add(file.id("Id"), file, std::move(settings));
  // Where D-Stability looked for slip planes has no meaning here: its keys are not asked for.
}

void read_result(JsonCursor& file, const std::string& name, StixParts& parts)
{
  StixResult result{.id = file.id("Id"), .name = name};
  result.is_reliability = name.substr(0, name.find('/')).ends_with("reliability");
  result.factor_of_safety = file.number("FactorOfSafety");
  result.reliability_index = file.number("ReliabilityIndex");
  result.failure_probability = file.number("FailureProbability");
  if (file.has("Converged")) result.converged = file.flag("Converged");
  if (file.has("Points")) result.slip_plane = file.places_given("Points");
  if (result.slip_plane.empty() && file.has("SlipPlane")) result.slip_plane = file.places_given("SlipPlane");
  std::size_t n_without_foot = 0;
  for (JsonCursor& entry : file.list("Slices")) {
    StixSlice slice = read_slice(entry, result);
    if (std::isfinite(slice.bottom_left[0] + slice.bottom_left[1] + slice.bottom_right[0] + slice.bottom_right[1]))
      result.slices.push_back(std::move(slice));
    else
      ++n_without_foot;
  }
  if (n_without_foot > 0) file.remark(filled<reported_texts::no_foot>(n_without_foot));
  const std::string id = result.id;
  parts.results.add(id, file, std::move(result));
}

}  // namespace terp
