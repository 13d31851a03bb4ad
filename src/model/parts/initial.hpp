// The stress with which a run starts (reading R14). Not for: the search for equilibrium (equilibrium.hpp).
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

#include <functional>
#include <optional>
#include <span>

namespace terp {

/// Horizontal over vertical effective stress with which soil starts at a place under a vertical stress [Pa, pressure
/// positive]: of the material, else of the case, else of its law. Soil with a friction angle phi and a yield stress has
/// (1 - sin phi) OCR^(sin phi) (Mayne and Kulhawy 1982), at most that of passive failure; other soil has 1.
Real k0_at(const Case& c, const MaterialCase& material, const PlaceInSoil& place, Real vertical);

/// True if a run begins with the K0 stress, or its search for equilibrium does: with water, soil whose stiffness
/// follows its stress, or a material that gives its k0.
bool begins_with_k0(const Case& c);

/// Of bodies that give it: their own stress. InitialStress::k0: effective sigma_yy = weight of soil, free water and
/// permanent loads above, as all of these are at t = 0, less p_w, effective sigma_xx = sigma_zz = k0 sigma_yy;
/// undrained soil stores them less p_w. None: zero. A search for equilibrium that begins_with_k0() has the same stress,
/// where all bodies have outlines. Throws InputError if a law cannot start with its stress. bodies: of the points, by
/// id.
void set_initial_stress(const Model& model, std::span<const Index> bodies, StepState& state);

/// The first point whose law cannot start with the stress that it has, among those for which look(id) is true: a
/// problem with its place. Laws whose strength follows the stress look at it.
std::optional<Problem> find_wrong_start(
    const Model& model, const StepState& state, const std::function<bool(std::size_t)>& look);

/// Words on the first point that carries more than the largest mean stress of its law; empty: none does.
std::string describe_overload(const Model& model, const StepState& state);

/// Gives the points the history that admits the stress of a search for equilibrium.
void start_soil(const Model& model, StepState& state);

}  // namespace terp
