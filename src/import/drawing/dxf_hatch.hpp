// The boundary paths of a HATCH, as chords.
// Not for: which of them bound soil (dxf_regions.hpp).
#pragma once

#include "import/drawing/dxf_shapes.hpp"

namespace terp {

/// Of code and value of its groups, from the number of paths (91) to the style (75): outlines around what is filled;
/// paths in them, whose insides are left free, only count in `n_holes`. Paths that are not whole are left out.
std::vector<std::vector<Vec<2>>> hatch_outlines(
    const std::vector<std::pair<int, Real>>& groups, Real tolerance, std::size_t& n_holes);

}  // namespace terp
