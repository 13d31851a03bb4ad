// Loads of a case: which material points carry them, and their forces in a step.
// Not for: what they did (run/measure/loads).
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "mpm/features/loads.hpp"
#include "mpm/step/step_state.hpp"

#include <string>
#include <vector>

namespace terp {

/// The loads of a stage of a case, with what they were before.
std::vector<Load> make_loads(const Case& description, const Case& before);

/// Pressure of a load by its number, at the start and in the stages that give it another one: "0 kPa, 13 kPa in
/// `flood`".
std::string describe_pressures(const Case& whole, std::size_t load);

/// Gives each load its row of the points.
void add_rows_of_loads(std::vector<Load>& loads, RowTable& rows);

/// Lets the points at the surface carry a load that begins now: each the part of the stretch that lies nearer to it
/// than to its neighbours, by linear shares, so that sum and first moment of the load are those of the stretch. Returns
/// why that cannot be, or nothing: there is no ground under a part of the stretch.
/// Points that the present stage digs away carry nothing.
std::string place_load(const Model& model, const Load& load, StepState& state);

/// Whether points that the present stage digs away carry a part of the load.
bool stands_on_what_goes(const Model& model, const Load& load, const StepState& state);

/// Places the loads that were always there, and looks whether there is ground for the others now. Throws InputError.
void place_first_loads(const Model& model, StepState& state);

/// Before a step: places the loads that begin with it. Returns why the run must stop itself, or nothing.
std::string place_due_loads(const Model& model, StepState& state);

}  // namespace terp
