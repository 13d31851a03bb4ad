// The same case with smaller strains: dynamic similarity in the limit of small displacements (decision 0035).
#pragma once

#include "simulation/case.hpp"

namespace terp {

/// The case whose strains and displacements are s times smaller and whose times are sqrt(s) times shorter, with the
/// same stresses, forces and accelerations. The laws' tables say what that takes (ParameterInfo::strain_exponent).
Case stiffen(Case c, Real s);

}  // namespace terp
