// Where the soil shears fastest: the slip surface as a line through the columns, of a field that is smooth over nodes.
// Definition: docs/formats.md.
#pragma once

#include "model/ground/section.hpp"
#include "mpm/mesh/mesh.hpp"

#include <span>

namespace terp {

struct SlipSurface {
  Real time = 0.0;           ///< end of the interval in which the strain grew [s]
  Real rate = 0.0;           ///< growth of the plastic strain, summed over the volume [m^2/s]
  std::vector<Vec<2>> line;  ///< from left to right, one place per column that shears [m]
};

/// A field of points as its nodes have it: the mean at each node, by N_i and volume, and at each point what the nodes
/// around it have. What alternates from cell to cell, as the increments of MPM-Mixed do, is gone; a band is wider by
/// less than a cell. values: in the order of for_each_point.
std::vector<float> mean_over_nodes(const Mesh<2>& mesh, const PointBlocks<2>& points, std::span<const float> values);

/// In each column the lowest point whose strain grew by at least half of the most in that column. A column counts if
/// that most is a tenth of what all but 0.1 % of the points stay below. growth: of eps_eq_p, in the order of
/// for_each_point.
std::vector<Vec<2>> find_slip_line(const PointBlocks<2>& points, std::span<const float> growth, const Columns& columns);

/// Of a slip line the longest part over which the ground moves the way that a slope faces: the sign of the sum of mass
/// times horizontal velocity over the ground in the column, from the line upwards. Where both slopes of a section slide
/// at once, each keeps its own.
std::vector<Vec<2>> part_below_motion(const std::vector<Vec<2>>& line, const PointBlocks<2>& points, Ground ground,
    const Columns& columns, Facing facing);

}  // namespace terp
