// Softening scaled by the cell over a reference width (soil/laws/scaled_softening.hpp): the scale of each cell, and
// cells that are too wide for it.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {

/// h/t_ref by cell, h = sqrt(V_e), shape [n_cells]; empty if the softening of the material is not scaled by the cell.
std::vector<Real> scale_by_cell(const Mesh<2>& mesh, const SoilMaterial& material);

/// Throws InputError where a cell with soil is so wide that it would snap back: a law refuses its shape factors times
/// h/t_ref.
void check_reference_widths(const Model& model, const StepState& state);

/// Such cells where no soil of the material is yet.
void find_wide_cells(const Model& model, const StepState& state, std::vector<Problem>& warnings);

}  // namespace terp
