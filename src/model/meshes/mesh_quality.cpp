// The time step follows from the smallest altitude, so altitudes are compared and not areas. The cost is relative to
// the median cell, which a few bad cells do not move. Parts are counted by a search over shared sides: cells that touch
// at a corner alone are two parts.

#include "model/meshes/mesh_quality.hpp"

#include "model/meshes/check_mesh.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace terp {
namespace {

Index count_parts(const Mesh<2>& mesh)
{
  std::vector<char> seen(mesh.cells.size(), false);
  std::vector<Index> open;
  Index n = 0;
  for (Index start = 0; start < mesh.n_cells(); ++start) {
    if (seen[start]) continue;
    ++n;
    seen[start] = true;
    open.push_back(start);
    while (!open.empty()) {
      const Index cell = open.back();
      open.pop_back();
      for (const Index next : mesh.neighbours[cell])
        if (next != outside && !seen[next]) {
          seen[next] = true;
          open.push_back(next);
        }
    }
  }
  return n;
}

/// Of an even number the higher of the two middle ones.
Real median(std::vector<Real> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void name_cell(const Mesh<2>& mesh, CellValue& at)
{
  at.name = cell_name(mesh, at.cell);
  at.centre = mesh.centres[at.cell];
}

std::string where(const CellValue& at)
{
  return fmt::format("{} at x={} y={}", at.name, coordinate_text(at.centre[0]), coordinate_text(at.centre[1]));
}

std::string warnings(const MeshQuality& quality)
{
  std::string text;
  if (quality.cost > costly)
    text += fmt::format("  warning: dt is set by {}: {:.3g}x smaller than the median\n",
        where(quality.smallest_altitude), quality.cost);
  if (quality.n_parts > 1)
    text += fmt::format("  warning: the mesh has {} parts that share no side; soil cannot pass from one to the other\n",
        quality.n_parts);
  return text;
}

}  // namespace

MeshQuality measure_quality(const Mesh<2>& mesh)
{
  MeshQuality quality;
  quality.n_cells = mesh.n_cells();
  quality.n_nodes = mesh.n_nodes();
  quality.n_parts = count_parts(mesh);
  quality.smallest_altitude = {mesh.smallest_altitude, mesh.cell_of_smallest_altitude, {}, {}};
  quality.smallest_jacobian.value = std::numeric_limits<Real>::infinity();
  std::vector<Real> altitudes;
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    const CornerShape shape = shape_of_corners(mesh.corners(e));
    const Real jacobian = std::min(1.0, std::ranges::min(shape.sine)),
               aspect = shape.longest / mesh.geometry(e).altitude;
    if (jacobian < quality.smallest_jacobian.value) quality.smallest_jacobian = {jacobian, e, {}, {}};
    if (aspect > quality.largest_aspect.value) quality.largest_aspect = {aspect, e, {}, {}};
    altitudes.push_back(mesh.geometry(e).altitude);
  }
  for (CellValue* at : {&quality.smallest_altitude, &quality.smallest_jacobian, &quality.largest_aspect})
    name_cell(mesh, *at);
  quality.median_altitude = median(std::move(altitudes));
  quality.cost = quality.median_altitude / quality.smallest_altitude.value;
  return quality;
}

std::string describe(const MeshQuality& quality)
{
  std::string text = fmt::format("  mesh           {} cells, {} nodes\n", quality.n_cells, quality.n_nodes);
  text += fmt::format("  smallest cell  {:.4g} m high, {}; median {:.4g} m\n", quality.smallest_altitude.value,
      where(quality.smallest_altitude), quality.median_altitude);
  text += fmt::format("  sharpest cell  scaled Jacobian {:.3f}, {}\n", quality.smallest_jacobian.value,
      where(quality.smallest_jacobian));
  text += fmt::format(
      "  slimmest cell  aspect ratio {:.3g}, {}\n", quality.largest_aspect.value, where(quality.largest_aspect));
  text += fmt::format("  mesh cost      {:.3g}x the time steps of the median cell\n", quality.cost);
  return text + warnings(quality);
}

}  // namespace terp
