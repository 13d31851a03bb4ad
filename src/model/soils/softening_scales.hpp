// A softening length against the cells and the section.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {

/// A softening length beside the sizes that it must fit.
struct SofteningScale {
  Index material;  ///< number
  Real length;     ///< l [m]
  Real cell;       ///< h: square root of the area of the largest cell that holds soil of the material [m]
  Real width;      ///< of the widest of them, between the middles of opposite sides [m]
  Real height;     ///< H: of all soil along gravity [m]
};

/// Of each material that has a length and points.
std::vector<SofteningScale> softening_scales(const Model& model, const StepState& state);

/// Least length over the width of a cell that holds soil with a length now [-]; NaN: there is no such soil.
Real least_length_over_width(const Model& model, const StepState& state);

/// Soil of some material softens point by point, so that its slip surfaces are as thin as the cells: results depend on
/// the mesh.
bool softens_point_by_point(const Model& model);

/// Throws InputError where a length of the materials spans so many cells that spreading over it would never end.
void check_cells_in_length(const Model& model, const std::vector<Index>& materials);

/// Throws InputError where a length is below the size of a cell.
void check_softening_lengths(const Model& model, const StepState& state);

/// Lengths that are poorly resolved, or long against the section.
void find_odd_softening_lengths(const Model& model, const StepState& state, std::vector<Problem>& warnings);

}  // namespace terp
