// Strength from its parameters: design values, SHANSEP, tables, and the Davis reduction. docs/dstability.md.
// Not for: the stresses that it is taken at (section.hpp).
#pragma once

#include "import/dstability/project.hpp"

#include <string_view>

namespace terp {

/// Which number of a parameter counts.
enum class StixBasis {
  deterministic,  ///< the plain value
  design,         ///< of what is probabilistic, the 5 % fractile of its lognormal distribution
  mean            ///< of what is probabilistic, the mean
};

/// What a calculation takes; of a probabilistic one the plain values.
StixBasis basis_of(StixCalculationKind kind);

/// The strengths that a calculation takes: "deterministic", "design", "mean", "probabilistic", "unknown".
std::string_view strengths_of(StixCalculationKind kind);
/// Those of a case, in the same words.
std::string_view strengths_of(StixBasis basis);

/// x that a lognormal variable of this mean and standard deviation falls below in 5 % of cases; in their unit. Not a
/// number without a deviation.
Real lognormal_fractile_5(Real mean, Real deviation);

/// Not a number where the file leaves it empty, or a mean or deviation that it follows from.
Real value_of(const StixParameter& parameter, StixBasis basis);

/// s_u = S sigma'_v (sigma'_y / sigma'_v)^m [Pa]; zero without effective stress. Stresses [Pa].
Real shansep_strength(Real ratio, Real exponent, Real effective_stress, Real yield_stress);

/// Strength of a table at an effective stress [Pa]; not a number if the table is empty.
Real table_strength(const StixTable& table, Real effective_stress, StixBasis basis);

/// Cohesion [Pa] and friction angle [degrees] of a material that dilates by psi and shears along its slip plane.
struct DavisStrength {
  Real cohesion, friction;
};

/// c* = c cos psi cos phi / d, tan phi* = cos psi sin phi / d, with d = 1 - sin psi sin phi. Angles [degrees].
DavisStrength davis_reduced(Real cohesion, Real friction, Real dilatancy);

/// c* and phi* of a soil of this model; of a model without them not a number.
DavisStrength drained_strength(const StixSoil& soil, StixStrengthModel model, StixBasis basis);

}  // namespace terp
