// Distances between lines of a drawing, and where lines miss each other by a little.
// Not for: closing such gaps (tidy_lines.hpp, planar_graph.hpp).
#pragma once

#include "import/drawing/dxf_file.hpp"
#include "mpm/mesh/box_grid.hpp"

namespace terp {

/// Lines that lie apart by more than `snap`, but by less than this, were meant to meet [m].
inline constexpr Real near_miss = 0.1;

std::size_t n_sides(const DxfLine& line);

/// Distance of a place from the nearest side of a line [m].
Real gap_to(const DxfLine& line, Vec<2> x);

BoundingBox wider(BoundingBox box, Real by);

/// Four corners, with sides along x and y.
bool is_rectangle(const DxfLine& line);

/// Each place of either lies within `snap` [m] of the other.
bool is_same_outline(const DxfLine& a, const DxfLine& b, Real snap);

/// Outlines that are open by mistake, and ends and corners that miss other lines: how many, and the first three with
/// their places and sizes, as a sentence; empty: none.
std::string doubt_of_gaps(const std::vector<DxfLine>& lines, Real snap);

}  // namespace terp
