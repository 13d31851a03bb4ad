#include "model/meshes/polygon_mesh.hpp"

#include "math/plane.hpp"
#include "mpm/mesh/box_grid.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

/// Cells in a strip of the width `distance` over which the size grows evenly from `small` to `large`: the integral of 1
/// / size^2.
Real cells_of_strip(Real length, Real distance, Real small, Real large) { return length * distance / (small * large); }

}  // namespace

Real estimate_cells(const PolygonMesh& mesh)
{
  Real twice_area = 0.0;
  for (std::size_t k = 0; k < mesh.polygon.size(); ++k)
    twice_area += cross(mesh.polygon[0], mesh.polygon[k], mesh.polygon[(k + 1) % mesh.polygon.size()]);
  return 0.5 * std::abs(twice_area) / (mesh.cell * mesh.cell);
}

Real estimate_more_cells(const PolygonMesh& mesh, const Refinement& refine)
{
  if (mesh.polygon.empty() || !(refine.cell < mesh.cell)) return 0.0;
  const BoundingBox box = box_around(mesh.polygon);
  const Real reach = std::min(refine.distance, std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]));
  Real n = 0.0;
  for (std::size_t k = 1; k < refine.line.size(); ++k)
    n += 2.0 * cells_of_strip(distance(refine.line[k - 1], refine.line[k]), reach, refine.cell, mesh.cell);
  if (!refine.line.empty()) return n;
  Vec<2> side;
  for (int d = 0; d < 2; ++d)
    side[d] = std::max<Real>(0.0, std::min(box.high[d], refine.high[d]) - std::max(box.low[d], refine.low[d]));
  return side[0] * side[1] / (refine.cell * refine.cell) +
         cells_of_strip(2.0 * (side[0] + side[1]), reach, refine.cell, mesh.cell);
}

}  // namespace terp
