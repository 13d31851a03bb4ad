// Parameters that vary, looked at over all points at once before a run: where they leave their range, their means, and
// whether files cover the soil. Not for: the value of a point (point_parameters.hpp).
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "model/soils/point_parameters.hpp"
#include "mpm/step/step_state.hpp"

#include <vector>

namespace terp {

/// Where parameters vary: gives the laws, and the description, the mean over the points as the value of each. Throws
/// InputError where a field leaves its range, with the place where it is worst, and where the file of a field covers
/// none of its soil. parts: with mesh and grounds. Gives the values of all points to be.
FieldsOfPoints settle_fields(const Parts& parts, Soils& soils);

/// The same values of laws that have been made.
FieldsOfPoints fields_of_points(const StageSoil& soil);

/// Fields from files that do not cover all of their soil.
void find_uncovered_soil(const Model& model, const StepState& state, std::vector<Problem>& warnings);

}  // namespace terp
