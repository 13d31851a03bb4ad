// Water in soil that moves. The table is a line of the soil and goes with it; free water stays where it is fed. The
// weight that limits the pressure is that of the soil as it lies. docs/methods.md, "Water"; decision 0085.
// Not for: the pressure that follows (nodal_water.hpp).
#pragma once

#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {

/// To which free water stands in columns [m], shape [n] as all; minus infinity: none. It stands where it is drawn above
/// the drawn ground, and beside that as far as the ground has come down below its level. A sloping line has the level
/// of its lowest place there.
/// walls: highest place of those between a column and the next, minus infinity: none.
std::vector<Real> free_water(const std::vector<Real>& level, const std::vector<Real>& drawn_ground,
    const std::vector<Real>& ground, const std::vector<Real>& walls);

/// Highest place of the walls between the middle of each column and that of the next [m].
std::vector<Real> walls_between(const Columns& columns, std::span<const WallCase> walls);

/// Looks at the soil before a step, where that is due. Nothing where the water does not follow the soil.
void look_at_soil(const Model& model, StepState& state);

/// The next step looks at the soil, and at the ground anew: a stage has changed bodies or water.
void look_anew(const Model& model, StepState& state);

}  // namespace terp
