#include "mpm/mesh/patch.hpp"

namespace terp {
namespace {

using QuadPatch = Patch<Quad4>;

int corner_at_node(const Mesh<2>& mesh, Index cell, Index node)
{
  int q = 0;
  while (mesh.cells[cell][q] != node) ++q;
  return q;
}

/// Partner across side s at one of its corners.
Index across_side(const Mesh<2>& mesh, Index cell, int s, bool at_second)
{
  const Index other = mesh.neighbours[cell][s];
  if (other == outside) return outside;
  const auto& corners = Quad4::sides[s].corners;
  const int here = corner_at_node(mesh, other, mesh.cells[cell][corners[at_second ? 1 : 0]]),
            there = corner_at_node(mesh, other, mesh.cells[cell][corners[at_second ? 0 : 1]]);
  const bool first = (here + 1) % Quad4::n_corners == there;  // `here` is the first corner of the other cell's side
  return QuadPatch::n_outer * other + (first ? 2 * here : 2 * there + 1);
}

/// Partner across corner q: the cell beside both neighbours, where four cells meet.
Index across_corner(const Mesh<2>& mesh, Index cell, int q)
{
  const Index node = mesh.cells[cell][q], before = mesh.neighbours[cell][(q + 3) % Quad4::n_sides],
              after = mesh.neighbours[cell][q];
  const Index begin = mesh.first_cell_of_node[node], end = mesh.first_cell_of_node[node + 1];
  if (before == outside || after == outside || end - begin != 4) return outside;
  for (Index k = begin; k < end; ++k) {
    const Index other = static_cast<Index>(mesh.cells_of_node[k].cell);
    if (other != cell && other != before && other != after)
      return QuadPatch::n_outer * other + QuadPatch::n_across_sides + static_cast<int>(mesh.cells_of_node[k].corner);
  }
  return outside;
}

}  // namespace

PatchPartners find_patch_partners(const Mesh<2>& mesh)
{
  PatchPartners partners(mesh.cells.size());
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    for (int s = 0; s < Quad4::n_sides; ++s)
      for (const bool at_second : {false, true})
        partners[cell][2 * s + (at_second ? 1 : 0)] = across_side(mesh, cell, s, at_second);
    for (int q = 0; q < Quad4::n_corners; ++q)
      partners[cell][QuadPatch::n_across_sides + q] = across_corner(mesh, cell, q);
  }
  return partners;
}

}  // namespace terp
