// connect() derives all tables from nodes and cells, each by one pass over the cells: neighbours from sorted edges,
// shared geometries from rounded corners, cells of each node in order of cell number. The order matters: nodes gather
// in it.
#include "mpm/mesh/mesh.hpp"

#include "math/errors.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace terp {
namespace {

using Corners = std::array<Vec<2>, 4>;

void find_neighbours(Mesh<2>& mesh)
{
  struct Edge {
    Index low, high;
    CellSide at;
  };
  std::vector<Edge> edges;
  edges.reserve(Quad4::n_sides * mesh.cells.size());
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int s = 0; s < Quad4::n_sides; ++s) {
      const auto [a, b] = Quad4::sides[s].corners;
      const auto [low, high] = std::minmax({mesh.cells[e][a], mesh.cells[e][b]});
      edges.push_back({low, high, {e, s}});
    }
  std::stable_sort(edges.begin(), edges.end(),
      [](const Edge& a, const Edge& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  mesh.neighbours.assign(mesh.cells.size(), {outside, outside, outside, outside});
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const Edge &a = edges[k - 1], &b = edges[k];
    if (a.low != b.low || a.high != b.high) continue;
    mesh.neighbours[a.at.cell][a.at.side] = b.at.cell;
    mesh.neighbours[b.at.cell][b.at.side] = a.at.cell;
  }
}

Vec<2> mean(const Corners& x)
{
  return {0.25 * (x[0][0] + x[1][0] + x[2][0] + x[3][0]), 0.25 * (x[0][1] + x[1][1] + x[2][1] + x[3][1])};
}

/// Equal cells share a geometry: corners relative to the centre that agree to 1e-12 of the size (round-off of a grid).
void share_geometries(Mesh<2>& mesh)
{
  std::map<std::array<std::int64_t, 8>, Index> known;
  mesh.geometry_of_cell.resize(mesh.cells.size());
  mesh.centres.resize(mesh.cells.size());
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    const Corners x = mesh.corners(e);
    mesh.centres[e] = mean(x);
    const Real size = std::hypot(x[2][0] - x[0][0], x[2][1] - x[0][1]);
    const Real unit = 1e-12 * std::exp2(std::round(std::log2(size)));
    std::array<std::int64_t, 8> key;
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) key[2 * i + d] = std::llround((x[i][d] - mesh.centres[e][d]) / unit);
    // A grid's round-off may fall on either side of a rounding edge: that only costs a second, equal entry.
    const auto [entry, is_new] = known.try_emplace(key, static_cast<Index>(mesh.geometries.size()));
    if (is_new) mesh.geometries.push_back(make_cell_geometry<Quad4>(x));
    mesh.geometry_of_cell[e] = entry->second;
  }
}

void list_cells_of_nodes(Mesh<2>& mesh)
{
  mesh.first_cell_of_node.assign(mesh.nodes.size() + 1, 0);
  for (const auto& cell : mesh.cells)
    for (const Index i : cell) ++mesh.first_cell_of_node[i + 1];
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) mesh.first_cell_of_node[i + 1] += mesh.first_cell_of_node[i];
  std::vector<Index> next(mesh.first_cell_of_node.begin(), mesh.first_cell_of_node.end() - 1);
  mesh.cells_of_node.resize(4 * mesh.cells.size());
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (Index c = 0; c < 4; ++c)
      mesh.cells_of_node[next[mesh.cells[e][c]]++] = {
          static_cast<std::uint32_t>(e) & 0x3fffffffu, static_cast<std::uint32_t>(c) & 3u};
}

/// Boxes are widened so that a position accepted by round-off (location_tolerance, 1e-10) lies in the box of its cell.
void make_cell_grid(Mesh<2>& mesh)
{
  std::vector<BoundingBox> boxes;
  boxes.reserve(mesh.cells.size());
  for (Index e = 0; e < mesh.n_cells(); ++e) boxes.push_back(widened(box_around(mesh.corners(e)), 1e-8));
  mesh.cell_grid = make_box_grid(boxes);
}

void find_smallest_altitude(Mesh<2>& mesh)
{
  mesh.smallest_altitude = std::numeric_limits<Real>::infinity();
  for (Index e = 0; e < mesh.n_cells(); ++e)
    if (mesh.geometry(e).altitude < mesh.smallest_altitude) {
      mesh.smallest_altitude = mesh.geometry(e).altitude;
      mesh.cell_of_smallest_altitude = e;
    }
}

}  // namespace

void connect(Mesh<2>& mesh)
{
  find_neighbours(mesh);
  share_geometries(mesh);
  list_cells_of_nodes(mesh);
  find_smallest_altitude(mesh);
  make_cell_grid(mesh);
}

Mesh<2> make_grid(std::vector<Vec<2>> nodes, std::array<Index, 2> n)
{
  TERP_ASSERT(static_cast<Index>(nodes.size()) == (n[0] + 1) * (n[1] + 1));
  Mesh<2> mesh;
  mesh.nodes = std::move(nodes);
  mesh.cells.reserve(static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]));
  const auto node = [&](Index i, Index j) { return j * (n[0] + 1) + i; };
  NamedSide left{"left", {}}, right{"right", {}}, bottom{"bottom", {}}, top{"top", {}};
  for (Index j = 0; j < n[1]; ++j)
    for (Index i = 0; i < n[0]; ++i) {
      const Index cell = mesh.n_cells();
      mesh.cells.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
      if (j == 0) bottom.edges.push_back({cell, 0});
      if (i == n[0] - 1) right.edges.push_back({cell, 1});
      if (j == n[1] - 1) top.edges.push_back({cell, 2});
      if (i == 0) left.edges.push_back({cell, 3});
    }
  mesh.sides = {left, right, bottom, top};
  connect(mesh);
  return mesh;
}

Mesh<2> make_rectangle(Vec<2> origin, Vec<2> size, std::array<Index, 2> n)
{
  std::vector<Vec<2>> nodes;
  nodes.reserve(static_cast<std::size_t>(n[0] + 1) * static_cast<std::size_t>(n[1] + 1));
  for (Index j = 0; j <= n[1]; ++j)
    for (Index i = 0; i <= n[0]; ++i) nodes.push_back({origin[0] + size[0] * i / n[0], origin[1] + size[1] * j / n[1]});
  return make_grid(std::move(nodes), n);
}

}  // namespace terp
