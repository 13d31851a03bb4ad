// The section that slopes and moved soil are measured against.
#pragma once

#include "events/section.hpp"
#include "simulation/setup_mesh.hpp"

namespace terp {

/// The surface of the points as they are, in columns of the width of a typical cell over the whole mesh.
inline Section first_section(const Mesh<2>& mesh, const PointBlocks<2>& points)
{
  const Vec<2> x = extent_in_x(mesh);
  return look_at_section(mesh, points, columns_between(x[0], x[1], typical_cell_size(mesh)));
}

}  // namespace terp
