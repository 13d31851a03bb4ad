// Only a cell that alone holds more than its area is looked at with its neighbours: where several hold too much
// together, one of them does alone. Of all cells over their limits the one furthest over it is named.

#include "model/bodies/overfull.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real round_off = 1e-9;
constexpr Real largest_point = 4.0;  // over the mean area of the cells around it

/// Length of the sides of the cells over which none of them lies [m].
Real length_of_outline(const Mesh<2>& mesh, const std::vector<Index>& cells)
{
  Real length = 0.0;
  for (const Index cell : cells) {
    const auto x = mesh.corners(cell);
    for (std::size_t side = 0; side < x.size(); ++side) {
      if (std::ranges::binary_search(cells, mesh.neighbours[cell][side])) continue;
      const Vec<2>&a = x[side], &b = x[(side + 1) % x.size()];
      length += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
  }
  return length;
}

Overfull look_around(const Mesh<2>& mesh, const CellContents& contents, Index cell)
{
  Overfull found{.cell = cell, .around = cells_around(mesh, cell)};
  Real largest = 0.0;
  for (const Index k : found.around) {
    found.volume += contents.volume[k];
    found.area += mesh.geometry(k).volume;
    largest = std::max(largest, contents.largest[k]);
  }
  const Real mean = found.area / static_cast<Real>(found.around.size()), own = contents.largest[cell],
             s = std::sqrt(std::min(largest, mean));
  if (own > largest_point * mean)
    return {.cell = cell,
        .around = {cell},
        .by_one_point = true,
        .volume = own,
        .area = mean,
        .limit = largest_point * mean};
  found.limit = found.area + length_of_outline(mesh, found.around) * s + 4.0 * s * s;
  return found;
}

}  // namespace

std::vector<Index> cells_around(const Mesh<2>& mesh, Index cell)
{
  std::vector<Index> around;
  for (const Index node : mesh.cells[cell])
    for (Index k = mesh.first_cell_of_node[node]; k < mesh.first_cell_of_node[node + 1]; ++k)
      around.push_back(static_cast<Index>(mesh.cells_of_node[k].cell));
  std::ranges::sort(around);
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

std::optional<Overfull> find_overfull(const Mesh<2>& mesh, const CellContents& contents)
{
  std::optional<Overfull> worst;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    if (contents.volume[cell] <= (1.0 + round_off) * mesh.geometry(cell).volume) continue;
    Overfull found = look_around(mesh, contents, cell);
    if (found.volume <= found.limit) continue;
    if (!worst || found.volume / found.limit > worst->volume / worst->limit) worst = std::move(found);
  }
  return worst;
}

}  // namespace terp
