#include "model/seepage/walls.hpp"

#include "math/errors.hpp"
#include "math/plane.hpp"
#include "mpm/mesh/locate.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace terp {
namespace {

constexpr Real near = 1e-3;     // of the least height of a cell: a node this near lies on a wall
constexpr int looks_at = 1000;  // places of a stretch of a wall that must lie on sides of cells

/// Sides of cells by their nodes, the smaller number first.
using Sides = std::set<std::array<Index, 2>>;

std::array<Index, 2> side_between(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// From 0 at a to 1 at b; none: the place does not lie on the way.
std::optional<Real> share_of_way(Vec<2> a, Vec<2> b, Vec<2> x, Real tolerance)
{
  const Vec<2> way = between(a, b);
  const Real t = dot(between(a, x), way) / dot(way, way);
  const bool is_on =
      distance_to_line(a, b, x) < tolerance && t > -tolerance / length(way) && t < 1.0 + tolerance / length(way);
  return is_on ? std::optional(t) : std::nullopt;
}

[[noreturn]] void refuse_place(const Mesh<2>& mesh, const std::string& path, Vec<2> x)
{
  const Vec<2> node = *std::ranges::min_element(mesh.nodes, {}, [&](const Vec<2>& at) { return distance(at, x); });
  throw InputError(Problem{path, "the wall does not run along sides of cells",
      fmt::format("It leaves them at ({:.4g}, {:.4g}) m; the nearest node lies at ({:.4g}, {:.4g}) m. Let all of the "
                  "wall, with both ends,\nlie on sides of cells: move it, or choose mesh.cell so that they do.",
          x[0], x[1], node[0], node[1]),
      "water.walls", false, {"mesh"}});
}

/// Adds the sides of cells from a to b. Where there is no soil, the line may leave them.
void add_sides(const Mesh<2>& mesh, Vec<2> a, Vec<2> b, const std::string& path,
    const std::function<bool(Vec<2>)>& has_soil, Sides& sides)
{
  const Real tolerance = near * mesh.smallest_altitude;
  std::vector<std::array<Real, 2>> covered;
  for (const auto& cell : mesh.cells)
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Index from = cell[i], to = cell[(i + 1) % cell.size()];
      const auto s = share_of_way(a, b, mesh.nodes[from], tolerance), t = share_of_way(a, b, mesh.nodes[to], tolerance);
      if (!s || !t) continue;
      sides.insert(side_between(from, to));
      covered.push_back({std::min(*s, *t), std::max(*s, *t)});
    }
  for (int k = 0; k < looks_at; ++k) {
    const Real t = (k + 0.5) / looks_at;
    const Vec<2> x = between(a, b, t);
    const auto holds = [t](const std::array<Real, 2>& part) { return part[0] <= t && t <= part[1]; };
    if (std::ranges::none_of(covered, holds) && locate(mesh, x).inside && has_soil(x)) refuse_place(mesh, path, x);
  }
  if (covered.empty()) refuse_place(mesh, path, a);
}

bool holds_soil(const Mesh<2>& mesh, Index cell, const std::function<bool(Vec<2>)>& has_soil)
{
  constexpr int n = 8;
  const auto corners = mesh.corners(cell);
  for (int i = 0; i < n * n; ++i) {
    const auto N = Quad4::shape_functions(std::array{-1.0 + 2.0 * (i % n + 0.5) / n, -1.0 + 2.0 * (i / n + 0.5) / n});
    Vec<2> x{0.0, 0.0};
    for (int c = 0; c < Quad4::n_corners; ++c)
      for (int d = 0; d < 2; ++d) x[d] += N[c] * corners[c][d];
    if (has_soil(x)) return true;
  }
  return false;
}

/// The cells about a node in groups that hang together by sides without a wall, and by soil; by place in
/// mesh.cells_of_node. Cells without soil belong to the first group.
std::vector<int> groups_about(
    const Mesh<2>& mesh, Index node, const Sides& walls, const std::function<bool(Vec<2>)>& has_soil)
{
  const std::span cells(mesh.cells_of_node.begin() + mesh.first_cell_of_node[node],
      mesh.cells_of_node.begin() + mesh.first_cell_of_node[node + 1]);
  const auto share_side = [&](Index a, Index b) {
    return std::ranges::any_of(mesh.cells[a], [&](Index other) {
      return other != node && std::ranges::find(mesh.cells[b], other) != mesh.cells[b].end() &&
             !walls.contains(side_between(node, other));
    });
  };
  std::vector<int> group(cells.size(), 0);
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (holds_soil(mesh, cells[k].cell, has_soil)) group[k] = -1;
  int n = 0;
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (group[first] >= 0) continue;
    std::vector<std::size_t> next{first};
    group[first] = n;
    while (!next.empty()) {
      const std::size_t from = next.back();
      next.pop_back();
      for (std::size_t k = 0; k < cells.size(); ++k)
        if (group[k] < 0 && share_side(cells[from].cell, cells[k].cell)) group[k] = n, next.push_back(k);
    }
    ++n;
  }
  return group;
}

}  // namespace

std::vector<Real> WalledMesh::joined(std::span<const Real> values) const
{
  const std::size_t n = mesh->nodes.size() - twins.size();
  std::vector<Real> sum(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
  std::vector<int> counts;
  for (Real& value : sum) counts.push_back(std::isnan(value) ? 0 : 1);
  for (std::size_t k = 0; k < twins.size(); ++k) {
    if (std::isnan(values[n + k])) continue;
    Real& value = sum[static_cast<std::size_t>(twins[k])];
    value = counts[static_cast<std::size_t>(twins[k])]++ > 0 ? value + values[n + k] : values[n + k];
  }
  for (std::size_t i = 0; i < n; ++i)
    if (counts[i] > 1) sum[i] /= counts[i];
  return sum;
}

WalledMesh with_walls(
    const SharedMesh& mesh, std::span<const WallCase> walls, const std::function<bool(Vec<2>)>& has_soil)
{
  WalledMesh walled{.mesh = mesh, .twins = {}};
  if (walls.empty()) return walled;
  Sides sides;
  for (std::size_t w = 0; w < walls.size(); ++w)
    for (std::size_t k = 0; k + 1 < walls[w].line.size(); ++k)
      add_sides(*mesh, walls[w].line[k], walls[w].line[k + 1], fmt::format("water.walls[{}]", w), has_soil, sides);
  std::set<Index> nodes;
  for (const auto& side : sides) nodes.insert(side.begin(), side.end());
  auto split = std::make_shared<Mesh<2>>(*mesh);
  for (const Index node : nodes) {
    const std::vector<int> group = groups_about(*mesh, node, sides, has_soil);
    const Index first = mesh->first_cell_of_node[node];
    const int n_groups = 1 + std::ranges::max(group);
    for (int g = 1; g < n_groups; ++g) {
      const Index twin = split->n_nodes();
      split->nodes.push_back(mesh->nodes[node]);
      walled.twins.push_back(node);
      for (std::size_t k = 0; k < group.size(); ++k) {
        const CellCorner& at = mesh->cells_of_node[first + static_cast<Index>(k)];
        if (group[k] == g) split->cells[at.cell][at.corner] = twin;
      }
    }
  }
  walled.mesh = std::move(split);
  return walled;
}

}  // namespace terp
