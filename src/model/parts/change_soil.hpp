// What the points of a state become where the soil becomes another: in a stage, or in a run that goes on from another.
// Not for: when that is (stages, other_run).
#pragma once

#include "model/bodies/setup_points.hpp"

namespace terp {

/// Whether each body is of the same material in both.
bool have_same_materials(const Model& a, const Model& b);

/// Whether any soil stores effective stress in one and total stress in the other.
bool stores_other_stress(const Model& before, const Model& model);

/// Soil that stored effective stress in the model before and stores total stress from now on, or the other way round:
/// the stress of both differs by the pore pressure of before, with all that the soil had in excess.
void change_stored_stress(const Model& before, const Model& model, const Seeds& seeds, StepState& state);

/// The mass of points whose material has another density than before follows it.
void change_densities(const Model& before, const Model& model, StepState& state);

/// The largest pressure that the soil of each point has been loaded to, by its number [Pa]; NaN: its law knows none.
std::vector<Real> carried_pressures(const Model& model, const StepState& state);

/// Gives points of a law that knows it the pressure that they had before, whatever yield stress the parameters of the
/// model give. The law counts from those.
void keep_carried_pressures(const Model& model, const std::vector<Real>& carried, StepState& state);

/// Gives each point the material that its body has in the stage of the model. Stress, strain and what both laws know
/// stay; what only the new law knows begins anew, and the mass follows the density. Of two laws of libraries, if they
/// are not the same one, only the plastic strain stays. carried: of the soil before. Throws RunError where a law does
/// not admit the stress of a point that is given to it.
void change_materials(const Model& model, const Seeds& seeds, const std::vector<Real>& carried, StepState& state);

}  // namespace terp
