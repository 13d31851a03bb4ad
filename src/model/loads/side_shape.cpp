#include "model/loads/side_shape.hpp"

#include <cmath>

namespace terp {

Side edge_of(const Mesh<2>& mesh, CellSide at)
{
  const auto& nodes = mesh.cells[at.cell];
  return {mesh.nodes[nodes[at.side]], mesh.nodes[nodes[(at.side + 1) % 4]]};
}

SideShape shape_of_side(const Mesh<2>& mesh, const NamedSide& side)
{
  SideShape shape;
  for (const CellSide& at : side.edges) {
    const auto [a, b] = edge_of(mesh, at);
    shape.length += std::hypot(b[0] - a[0], b[1] - a[1]);
    shape.normal = {shape.normal[0] + b[1] - a[1], shape.normal[1] + a[0] - b[0]};
  }
  if (shape.length > 0.0) shape.normal = {shape.normal[0] / shape.length, shape.normal[1] / shape.length};
  return shape;
}

SideCondition condition_of(const Case& description, const std::string& side)
{
  for (const SideCondition& known : description.sides)
    if (known.side == side) return known;
  SideCondition free;
  free.side = side;
  return free;
}

}  // namespace terp
