// The elastic parameters that all isotropic laws share.
#pragma once

#include "materials/material.hpp"

namespace terp {

inline constexpr ParameterInfo shear_modulus_info{"shear_modulus", "Pa", positive, "elastic shear modulus G", {},
    {1e4, 1e11, false, false}, {}, Reduction::none, StrainScale::multiply};
inline constexpr ParameterInfo poisson_ratio_info{
    "poisson_ratio", "-", {0.0, 0.5, false, true}, "Poisson's ratio, drained or undrained to suit the analysis"};

/// K = 2 G (1 + nu) / (3 (1 - 2 nu)) [Pa].
constexpr Real bulk_from_poisson(Real shear, Real poisson)
{
  return 2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson));
}

}  // namespace terp
