#include "simulation/side_shape.hpp"

#include <cmath>
#include <fmt/format.h>

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

SideCase condition_of(const Case& description, const std::string& side)
{
  for (const SideCase& known : description.sides)
    if (known.side == side) return known;
  SideCase free;
  free.side = side;
  return free;
}

std::string describe(const SideCase& side)
{
  std::string resistance;
  if (side.adhesion > 0.0) resistance += fmt::format(", adhesion {:.4g} kPa", side.adhesion / 1e3);
  if (side.friction > 0.0) resistance += fmt::format(", friction {:.4g}", side.friction);
  if (resistance.empty()) resistance = ", smooth";
  switch (side.kind) {
    case SideKind::free: break;
    case SideKind::open: return "open, soil leaves there";
    case SideKind::roller: return "roller, no motion across";
    case SideKind::fixed: return "fixed";
    case SideKind::contact_bilateral: return "contact that never opens" + resistance;
    case SideKind::contact_separating: return "contact that may open" + resistance;
    case SideKind::velocity:
      return (side.velocity_at ? std::string("velocity by a formula")
                               : fmt::format("velocity [{:.4g}, {:.4g}] m/s", side.velocity[0], side.velocity[1])) +
             (side.slip ? ", smooth" : "");
  }
  return "free, holds nothing";
}

}  // namespace terp
