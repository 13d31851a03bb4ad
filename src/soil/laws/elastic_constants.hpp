// The elastic parameters that all isotropic laws share.
#pragma once

#include "soil/laws/material.hpp"

namespace terp {

inline constexpr ParameterInfo shear_modulus_info{.name = "shear_modulus",
    .unit = "Pa",
    .range = positive,
    .typical = 2e6,
    .meaning = "elastic shear modulus G",
    .usual = between(1e4, 1e11),
    .strain_exponent = 1.0,
    .may_vary = true};
inline constexpr ParameterInfo poisson_ratio_info{.name = "poisson_ratio",
    .unit = "-",
    .range = {0.0, 0.5, false, true},
    .typical = 0.48,
    .meaning = "Poisson's ratio, drained or undrained to suit the analysis",
    .may_vary = true};

/// The same parameter, which may also be given by a ratio.
constexpr ParameterInfo with_ratio(ParameterInfo info, const RatioInfo& ratio)
{
  info.ratio = ratio;
  return info;
}

/// K = 2 G (1 + nu) / (3 (1 - 2 nu)) [Pa].
template <class P>
constexpr P bulk_from_poisson(P shear, P poisson)
{
  return 2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson));
}

/// Poisson's ratio of isotropic moduli [-].
constexpr Real poisson_ratio_of(const Moduli& m)
{
  return (3.0 * m.bulk - 2.0 * m.shear) / (2.0 * (3.0 * m.bulk + m.shear));
}

}  // namespace terp
