// The parameter that all laws with exponential softening share. Not for: what softens, which each law says itself.
#pragma once

#include "soil/laws/material.hpp"

namespace terp {

inline constexpr ParameterInfo eta_info{.name = "eta",
    .unit = "-",
    .range = not_negative,
    .typical = 50.0,
    .meaning = "shape factor of the softening, Eq. (5); 95 % of it is done at a strain of 3/eta",
    .fallback = 0.0,
    .strain_exponent = 1.0,
    .may_vary = true};

}  // namespace terp
