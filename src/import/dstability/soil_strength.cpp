// Nothing is refused here: a parameter that is not given is not a number, and this passes on to the strength. The
// design value of a lognormal variable follows from the normal distribution of its logarithm. A table has one
// coefficient of variation, so its design value is the same share of every row.

#include "import/dstability/soil_strength.hpp"

#include "math/interpolate.hpp"

#include <cmath>
#include <numbers>

namespace terp {
namespace {

constexpr Real normal_fractile_5 = -1.6448536269514722;  // of the standard normal distribution
constexpr Real radians_per_degree = std::numbers::pi / 180.0;

}  // namespace

StixBasis basis_of(StixCalculationKind kind)
{
  if (kind == StixCalculationKind::design) return StixBasis::design;
  return kind == StixCalculationKind::mean ? StixBasis::mean : StixBasis::deterministic;
}

std::string_view strengths_of(StixCalculationKind kind)
{
  switch (kind) {
    case StixCalculationKind::deterministic: return "deterministic";
    case StixCalculationKind::design: return "design";
    case StixCalculationKind::mean: return "mean";
    case StixCalculationKind::probabilistic: return "probabilistic";
    case StixCalculationKind::unknown: break;
  }
  return "unknown";
}

std::string_view strengths_of(StixBasis basis)
{
  return basis == StixBasis::design ? "design" : basis == StixBasis::mean ? "mean" : "deterministic";
}

Real lognormal_fractile_5(Real mean, Real deviation)
{
  if (std::isnan(deviation)) return not_given;
  if (!(mean > 0.0) || !(deviation > 0.0)) return mean;
  const Real variance_of_log = std::log1p((deviation / mean) * (deviation / mean));
  return mean * std::exp(-0.5 * variance_of_log + normal_fractile_5 * std::sqrt(variance_of_log));
}

Real value_of(const StixParameter& parameter, StixBasis basis)
{
  if (basis == StixBasis::deterministic || !parameter.is_probabilistic) return parameter.value;
  return basis == StixBasis::mean ? parameter.mean : lognormal_fractile_5(parameter.mean, parameter.deviation);
}

Real shansep_strength(Real ratio, Real exponent, Real effective_stress, Real yield_stress)
{
  if (!(effective_stress > 0.0)) return 0.0;
  return ratio * effective_stress * std::pow(yield_stress / effective_stress, exponent);
}

Real table_strength(const StixTable& table, Real effective_stress, StixBasis basis)
{
  if (table.rows.empty()) return not_given;
  const Real share =
      basis == StixBasis::design && table.is_probabilistic ? lognormal_fractile_5(1.0, table.variation) : 1.0;
  return share * interpolate(table.rows, effective_stress);
}

DavisStrength davis_reduced(Real cohesion, Real friction, Real dilatancy)
{
  const Real phi = friction * radians_per_degree, psi = dilatancy * radians_per_degree;
  const Real divisor = 1.0 - std::sin(psi) * std::sin(phi);
  return {cohesion * std::cos(psi) * std::cos(phi) / divisor,
      std::atan(std::cos(psi) * std::sin(phi) / divisor) / radians_per_degree};
}

DavisStrength drained_strength(const StixSoil& soil, StixStrengthModel model, StixBasis basis)
{
  const auto of = [basis](const StixParameter& parameter) { return value_of(parameter, basis); };
  if (model == StixStrengthModel::advanced)
    return davis_reduced(of(soil.advanced.cohesion), of(soil.advanced.friction), of(soil.advanced.dilatancy));
  if (model == StixStrengthModel::classic) return {of(soil.classic.cohesion), of(soil.classic.friction)};
  return {not_given, not_given};
}

}  // namespace terp
