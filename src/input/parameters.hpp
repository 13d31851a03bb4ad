// Parameters of a material once its section is read: those that follow from a ratio or from another one.
#pragma once

#include "base/errors.hpp"
#include "simulation/case.hpp"

#include <vector>

namespace terp {

/// Fills in what was left out: from ratios (su_residual from sensitivity), defaults, and other parameters. One that
/// follows from a field is a field. Problems: a ratio beside the parameter that it stands for.
std::vector<Problem> complete_parameters(const MaterialType& law, MaterialCase& material);

}  // namespace terp
