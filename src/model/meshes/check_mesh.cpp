// From the simple to the expensive: numbers, each cell by itself, cells that exist twice, edges. Hanging nodes and
// double nodes lie on the boundary of connected cells. Overlap is tested last, and only if nothing else is wrong. A
// faulty cell takes no part in the later checks, so one fault is reported once.
#include "model/meshes/check_mesh.hpp"

#include "math/plane.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace terp {
namespace {

constexpr Real largest_coordinate = 1e9;  // [m]; beyond it a cell of a metre is near round-off

const std::string reshape_advice =
    "Every cell must be convex. In gmsh: optimise the mesh (Optimize Mesh, Laplace2D), use a smaller element size "
    "there, or recombine with Mesh.SubdivisionAlgorithm = 1.";
const std::string turn_advice =
    "The nodes of a cell run counter-clockwise. A surface drawn the other way round, all its cells clockwise, is "
    "turned; among others such a cell is folded over. In gmsh: move its nodes, optimise the mesh, or use a smaller "
    "element size there. In a file written by a program: give its nodes in the other order.";
const std::string coherence_advice =
    "Two surfaces that touch must share their curve and its nodes. In gmsh: `Coherence;` in the .geo file before "
    "meshing, or `Coherence Mesh;` after it (Tools menu: Remove duplicate nodes).";

/// Faults that make all other checks impossible.
void check_numbers(const Mesh<2>& mesh)
{
  MeshFaults faults("the mesh");
  if (mesh.cells.empty()) faults.add("it has no cells", "", "");
  for (Index i = 0; i < mesh.n_nodes(); ++i)
    for (const Real x : mesh.nodes[i])
      if (!(std::abs(x) <= largest_coordinate)) {
        faults.add("a coordinate is not a length that Terp can use", node_name(mesh, i),
            fmt::format("Coordinates are in metres, finite, at most {:g} m.", largest_coordinate));
        break;
      }
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (const Index i : mesh.cells[e])
      if (i < 0 || i >= mesh.n_nodes())
        faults.add(fmt::format("{} names node {}, of {}", cell_name(mesh, e), i, mesh.n_nodes()), "", "");
  faults.stop_if_any();
}

/// What is wrong with the shape of a cell; empty if nothing.
std::string fault_of_shape(const Mesh<2>& mesh, Index cell)
{
  const auto& nodes = mesh.cells[cell];
  if (std::set<Index>(nodes.begin(), nodes.end()).size() < 4) return "is degenerate: it names a node twice";
  const CornerShape shape = shape_of_corners(mesh.corners(cell));
  if (shape.side_without_length) return "is degenerate: two of its nodes lie at one place";
  const auto worst = std::min_element(shape.sine.begin(), shape.sine.end()) - shape.sine.begin();
  if (shape.sine[worst] > degenerate_share) return {};
  const auto turned = std::count_if(shape.sine.begin(), shape.sine.end(), [](Real s) { return s < -degenerate_share; });
  const std::string where = fmt::format(": detJ = {:.3g} m^2 at {}", shape.det[worst], node_name(mesh, nodes[worst]));
  if (turned == 4) return "is inverted, its nodes run clockwise" + where;
  if (turned == 2) return "crosses itself" + where;
  if (turned > 0) return "is not convex" + where;
  return "is degenerate, a corner is straight" + where;
}

void check_shapes(const Mesh<2>& mesh, std::vector<char>& usable, MeshFaults& faults)
{
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    const std::string fault = fault_of_shape(mesh, e);
    if (fault.empty()) continue;
    usable[e] = false;
    faults.add(cell_name(mesh, e) + " " + fault, corner_names(mesh, e),
        fault.starts_with("is inverted") ? turn_advice : reshape_advice);
  }
}

void check_duplicates(const Mesh<2>& mesh, std::vector<char>& usable, MeshFaults& faults)
{
  std::map<std::array<Index, 4>, Index> known;
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    if (!usable[e]) continue;
    auto nodes = mesh.cells[e];
    std::sort(nodes.begin(), nodes.end());
    const auto [first, is_new] = known.try_emplace(nodes, e);
    if (is_new) continue;
    usable[e] = false;
    faults.add(fmt::format("{} and {} have the same nodes", cell_name(mesh, first->second), cell_name(mesh, e)),
        corner_names(mesh, e),
        "Remove one of the two. In gmsh: Tools menu, Remove duplicate elements; look for two surfaces at one place.");
  }
}

struct Edge {
  Index low, high;  // nodes, low < high
  Index from;       // the first node when going round the cell
  Index cell;
};

/// In order of nodes, then of cells.
std::vector<Edge> edges_of(const Mesh<2>& mesh, const std::vector<char>& usable)
{
  std::vector<Edge> edges;
  edges.reserve(4 * mesh.cells.size());
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int s = 0; s < 4 && usable[e]; ++s) {
      const auto [low, high] = std::minmax({mesh.cells[e][s], mesh.cells[e][(s + 1) % 4]});
      edges.push_back({low, high, mesh.cells[e][s], e});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::array{a.low, a.high, a.cell} < std::array{b.low, b.high, b.cell};
  });
  return edges;
}

void check_shared_edge(const Mesh<2>& mesh, std::span<const Edge> shared, MeshFaults& faults)
{
  const std::string nodes = node_name(mesh, shared[0].low) + ", " + node_name(mesh, shared[0].high);
  if (shared.size() > 2) {
    std::string cells;
    for (const Edge& edge : shared) cells += (cells.empty() ? "" : ", ") + cell_name(mesh, edge.cell);
    faults.add(fmt::format("a side is shared by {} cells: {}", shared.size(), cells), nodes,
        "A side belongs to one or two cells. Look for surfaces that overlap.");
  } else if (shared[0].from == shared[1].from) {
    faults.add(fmt::format("{} and {} lie on the same side of their common side", cell_name(mesh, shared[0].cell),
                   cell_name(mesh, shared[1].cell)),
        nodes, "The mesh is folded there: one of the two cells is inverted. " + reshape_advice);
  }
}

/// Edges of one cell only: the boundary of the mesh.
std::vector<Edge> check_edges(const Mesh<2>& mesh, const std::vector<char>& usable, MeshFaults& faults)
{
  const std::vector<Edge> edges = edges_of(mesh, usable);
  std::vector<Edge> boundary;
  for (std::size_t k = 0, end = 0; k < edges.size(); k = end) {
    while (end < edges.size() && edges[end].low == edges[k].low && edges[end].high == edges[k].high) ++end;
    if (end - k == 1)
      boundary.push_back(edges[k]);
    else
      check_shared_edge(mesh, std::span(edges).subspan(k, end - k), faults);
  }
  return boundary;
}

/// Where a node lies on the edge of a cell it does not belong to.
enum class OnEdge { no, inside, at_low, at_high };

OnEdge place_on_edge(const Mesh<2>& mesh, const Edge& edge, Index node)
{
  const Vec<2> along = between(mesh.nodes[edge.low], mesh.nodes[edge.high]),
               to = between(mesh.nodes[edge.low], mesh.nodes[node]);
  const Real reach = degenerate_share * length(along);
  if (length(to) <= reach) return OnEdge::at_low;
  if (length(between(mesh.nodes[edge.high], mesh.nodes[node])) <= reach) return OnEdge::at_high;
  const Real share = (to[0] * along[0] + to[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
  const bool is_beside = share > 0.0 && share < 1.0 && std::abs(cross(along, to)) <= reach * length(along);
  return is_beside ? OnEdge::inside : OnEdge::no;
}

void report_node_on_edge(
    const Mesh<2>& mesh, const Edge& edge, Index node, std::set<std::pair<Index, Index>>& known, MeshFaults& faults)
{
  if (node == edge.low || node == edge.high) return;
  const OnEdge place = place_on_edge(mesh, edge, node);
  if (place == OnEdge::no) return;
  if (place == OnEdge::inside) {
    faults.add(fmt::format("{} has a hanging node inside a side", cell_name(mesh, edge.cell)),
        fmt::format(
            "{} lies between {} and {}", node_name(mesh, node), node_name(mesh, edge.low), node_name(mesh, edge.high)),
        "Cells must meet side to side. " + coherence_advice);
    return;
  }
  const Index other = place == OnEdge::at_low ? edge.low : edge.high;
  if (known.insert(std::minmax(node, other)).second)
    faults.add("two nodes lie at one place",
        node_name(mesh, std::min(node, other)) + ", " + node_name(mesh, std::max(node, other)), coherence_advice);
}

/// Hanging nodes and nodes at one position: both lie on the boundary of connected cells.
void check_boundary_nodes(const Mesh<2>& mesh, const std::vector<Edge>& boundary, MeshFaults& faults)
{
  std::vector<BoundingBox> boxes;
  std::set<Index> nodes;
  for (const Edge& edge : boundary) {
    boxes.push_back(
        widened(box_around(std::array{mesh.nodes[edge.low], mesh.nodes[edge.high]}), 2.0 * degenerate_share));
    nodes.insert({edge.low, edge.high});
  }
  const BoxGrid grid = make_box_grid(boxes);
  std::set<std::pair<Index, Index>> known;
  for (const Index node : nodes)
    for (const Index k : boxes_near(grid, mesh.nodes[node]))
      report_node_on_edge(mesh, boundary[k], node, known, faults);
}

bool is_inside(const std::array<Vec<2>, 4>& corners, Vec<2> x)
{
  for (int s = 0; s < 4; ++s)
    if (cross(between(corners[s], corners[(s + 1) % 4]), between(corners[s], x)) <= 0.0) return false;
  return true;
}

/// Cells of surfaces that lie over each other without sharing a node: the centre of one lies in the other.
void check_overlap(const Mesh<2>& mesh, MeshFaults& faults)
{
  std::vector<BoundingBox> boxes;
  for (Index e = 0; e < mesh.n_cells(); ++e) boxes.push_back(box_around(mesh.corners(e)));
  const BoxGrid grid = make_box_grid(boxes);
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    const auto x = mesh.corners(e);
    const Vec<2> centre{0.25 * (x[0][0] + x[1][0] + x[2][0] + x[3][0]), 0.25 * (x[0][1] + x[1][1] + x[2][1] + x[3][1])};
    for (const Index other : boxes_near(grid, centre))
      if (other != e && is_inside(mesh.corners(other), centre))
        faults.add(fmt::format("{} and {} overlap", cell_name(mesh, e), cell_name(mesh, other)), corner_names(mesh, e),
            "A place may belong to one cell only. Look for surfaces that overlap, or are meshed twice.");
  }
}

}  // namespace

CornerShape shape_of_corners(const std::array<Vec<2>, 4>& x)
{
  CornerShape shape;
  std::array<Vec<2>, 4> side;
  for (int s = 0; s < 4; ++s) {
    side[s] = between(x[s], x[(s + 1) % 4]);
    shape.longest = std::max(shape.longest, length(side[s]));
  }
  for (int i = 0; i < 4; ++i) {
    const Vec<2>&before = side[(i + 3) % 4], &after = side[i];
    shape.side_without_length = shape.side_without_length || length(after) <= degenerate_share * shape.longest;
    shape.det[i] = 0.25 * cross(before, after);
    shape.sine[i] = cross(before, after) / (length(before) * length(after));
  }
  return shape;
}

void check_mesh(const Mesh<2>& mesh)
{
  check_numbers(mesh);
  MeshFaults faults("the mesh");
  std::vector<char> usable(mesh.cells.size(), true);
  check_shapes(mesh, usable, faults);
  check_duplicates(mesh, usable, faults);
  const std::vector<Edge> boundary = check_edges(mesh, usable, faults);
  check_boundary_nodes(mesh, boundary, faults);
  if (faults.empty()) check_overlap(mesh, faults);
  faults.stop_if_any();
}

}  // namespace terp
