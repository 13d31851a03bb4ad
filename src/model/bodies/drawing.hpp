// Bodies as drawn over a mesh: which of them matter in a cell.
// Not for: points (seed.hpp), nor how a cell is shared out (overlay.hpp).
#pragma once

#include "model/bodies/overlay.hpp"
#include "mpm/mesh/mesh.hpp"

#include <span>
#include <vector>

namespace terp {

struct Drawing {
  const Mesh<2>& mesh;
  std::span<const BodyOutline> bodies;
  std::vector<BoundingBox> boxes;  ///< of the polygons, shape [n_bodies]
  std::vector<std::vector<char>>
      in_region;  ///< of bodies of whole cells: 1 if the cell is one, shape [n_bodies][n_cells or 0]
};

/// The mesh and the outlines must outlive it.
Drawing make_drawing(const Mesh<2>& mesh, std::span<const BodyOutline> bodies);

/// The bodies in a cell; no rings and no ground: none.
Overlay draw_cell(const Drawing& drawing, Index cell);

}  // namespace terp
