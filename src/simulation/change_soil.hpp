// What the points of a state become where the soil becomes another: in a stage, or in a run that goes on from another.
// Not for: when that is (stages, other_run).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace terp {

/// Whether each body is of the same material in both.
bool have_same_materials(const Model& a, const Model& b);

/// Whether any soil stores effective stress in one and total stress in the other.
bool stores_other_stress(const Model& before, const Model& model);

/// Soil that stored effective stress in the model before and stores total stress from now on, or the other way round:
/// the stress of both differs by the pore pressure of before, with all that the soil had in excess.
void change_stored_stress(const Model& before, const Model& model, State& state);

/// The mass of points whose material has another density than before follows it.
void change_densities(const Model& before, const Model& model, State& state);

/// Gives each point the material that its body has in the stage of the model. Stress, strain and what both laws know
/// stay; what only the new law knows begins anew, and the mass follows the density.
void change_materials(const Model& model, State& state);

}  // namespace terp
