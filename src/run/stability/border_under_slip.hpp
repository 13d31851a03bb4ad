// Where a slip surface runs along the top of an aquifer that lifts the soil above it: what its row of cells carries
// more than that top, beside the strength of all of the slip surface. docs/stability.md, "The error of the mesh".
#pragma once

#include "run/stability/mechanism.hpp"

namespace terp {

/// line: of the slip surface, from left to right [m]. Of several borders that which carries most more. The strength is
/// the shear stress along the line, which soil that fails has in full.
std::optional<BorderUnderSlip> find_border_under(
    const Model& model, const State& state, const std::vector<Vec<2>>& line);

}  // namespace terp
