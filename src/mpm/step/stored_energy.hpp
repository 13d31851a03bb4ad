// Energy of points and of their pore water. Not for: the walk over all points (totals), nor the balance (ledger).
#pragma once

#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {

/// Elastic energy stored in a point [J per m]; sigma: xx yy zz xy [Pa], volume [m^2].
Real elastic_energy(Moduli moduli, std::array<Real, 4> sigma, Real volume);

/// Stored in a point of a material and in its pore water [J per m]; values: its rows.
Real elastic_energy(const SoilMaterial& material, std::span<Real> values);

/// Of the points that left, when they did [J per m].
Real energy_of_left(const StepState& state);

/// Kinetic energy of the points plus elastic energy stored in them and in their pore water, and what those that left
/// took along [J per m].
Real kinetic_and_stored_energy(const StepModel& model, const StepState& state);

}  // namespace terp
