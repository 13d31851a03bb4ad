// The order counts: cells are sorted along the curve before regions and sides are made, which refer to them by number.
// The mesh is checked before sides are looked up by the edges of its cells, so that a faulty cell is reported first.

#include "model/meshes/gmsh_file.hpp"

#include "math/errors.hpp"
#include "model/meshes/check_mesh.hpp"
#include "model/meshes/msh_content.hpp"
#include "os/read_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <unordered_map>

namespace terp {
namespace {

const std::string all_quads_advice =
    "Terp takes 4-node quadrilaterals only. In gmsh: `Recombine Surface {:};` with Mesh.SubdivisionAlgorithm = 1 (all "
    "quads) and Mesh.ElementOrder = 1.";

std::string contents_of(const std::string& path)
{
  std::string text;
  try {
    text = read_file(path);
  } catch (const FileError& error) {
    throw MeshError(error.what());
  }
  if (!text.empty()) return text;
  throw MeshError(path + ": the file is empty. In gmsh: mesh the section (Mesh, 2D), then save it as MSH 4.1.");
}

using NodeTable = std::unordered_map<std::int64_t, std::size_t>;

NodeTable number_nodes(const MshContent& content)
{
  NodeTable table;
  MeshFaults faults("the file");
  for (std::size_t k = 0; k < content.node_numbers.size(); ++k)
    if (!table.try_emplace(content.node_numbers[k], k).second)
      faults.add(fmt::format("node {} is there twice", content.node_numbers[k]), "", "Save the mesh again with gmsh.");
  faults.stop_if_any();
  return table;
}

/// "nodes 5 at (0.1, 0.2), 6 (not in the file)".
std::string places_of(const MshContent& content, const NodeTable& table, const MshElement& element)
{
  std::string text = "nodes";
  for (int k = 0; k < std::min(element.n_nodes, 4); ++k) {
    const auto at = table.find(element.nodes[k]);
    text += fmt::format("{} {}", k == 0 ? "" : ",", element.nodes[k]);
    if (at == table.end())
      text += " (not in the file)";
    else
      text += fmt::format(" at {}", place_text({content.places[at->second][0], content.places[at->second][1]}));
  }
  return text + (element.n_nodes > 4 ? ", ... m" : " m");
}

void refuse_other_elements(const MshContent& content, const NodeTable& table)
{
  MeshFaults faults("the file");
  for (const MshElement& element : content.others)
    faults.add(fmt::format("element {} is a {}", element.number, msh_type_name(element.type)),
        places_of(content, table, element), all_quads_advice);
  faults.count_more(content.n_others - static_cast<std::int64_t>(content.others.size()));
  if (content.n_others == 0 && content.quads.empty())
    faults.add("it holds no quadrilaterals", "",
        all_quads_advice +
            " Where there are physical groups gmsh saves only what is in one: put the surfaces in a group.");
  faults.stop_if_any();
}

void refuse_unknown_nodes(const MshContent& content, const NodeTable& table)
{
  MeshFaults faults("the file");
  for (const auto* elements : {&content.quads, &content.lines})
    for (const MshElement& element : *elements)
      if (std::any_of(element.nodes.begin(), element.nodes.begin() + element.n_nodes,
              [&](std::int64_t node) { return !table.contains(node); }))
        faults.add(fmt::format("element {} names a node that is not there", element.number),
            places_of(content, table, element), "Save the mesh again with gmsh.");
  faults.stop_if_any();
}

struct FileCell {
  std::array<Index, 4> nodes;  // into MshContent::places
  std::int64_t number;
  int surface;   // gmsh's entity
  Index groups;  // into MshContent::group_sets
};

std::vector<FileCell> cells_of_quads(const MshContent& content, const NodeTable& table)
{
  std::vector<FileCell> cells;
  for (const MshElement& quad : content.quads) {
    cells.push_back({{}, quad.number, quad.entity, quad.groups});
    for (int k = 0; k < 4; ++k) cells.back().nodes[k] = static_cast<Index>(table.at(quad.nodes[k]));
  }
  return cells;
}

Real signed_area(const MshContent& content, const std::array<Index, 4>& nodes)
{
  const auto &a = content.places[nodes[0]], &b = content.places[nodes[1]], &c = content.places[nodes[2]],
             &d = content.places[nodes[3]];
  return 0.5 * ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]));
}

bool is_counter_clockwise_and_convex(const MshContent& content, const std::array<Index, 4>& nodes)
{
  for (int k = 0; k < 4; ++k) {
    const auto &a = content.places[nodes[k]], &b = content.places[nodes[(k + 1) % 4]],
               &c = content.places[nodes[(k + 2) % 4]];
    if (!((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 0.0)) return false;
  }
  return true;
}

/// A surface drawn the other way round has clockwise cells only: they are turned. One among others is a fault, which
/// check_mesh tells.
void turn_clockwise_surfaces(const MshContent& content, std::vector<FileCell>& cells)
{
  std::set<int> drawn_as_we_want;
  for (const FileCell& cell : cells)
    if (is_counter_clockwise_and_convex(content, cell.nodes)) drawn_as_we_want.insert(cell.surface);
  for (FileCell& cell : cells)
    if (!drawn_as_we_want.contains(cell.surface) && signed_area(content, cell.nodes) < 0.0)
      std::swap(cell.nodes[1], cell.nodes[3]);
}

/// Distance along the Hilbert curve through a square of 65536 x 65536: quadrant by quadrant, each turned so that the
/// ends meet.
std::uint64_t hilbert_distance(std::uint32_t x, std::uint32_t y)
{
  constexpr std::uint32_t size = 1u << 16;
  std::uint64_t distance = 0;
  for (std::uint32_t s = size / 2; s > 0; s /= 2) {
    const bool right = (x & s) != 0, upper = (y & s) != 0;
    distance += std::uint64_t{s} * s * ((right ? 3u : 0u) ^ (upper ? 1u : 0u));
    if (upper) continue;
    if (right) {
      x = size - 1 - x;
      y = size - 1 - y;
    }
    std::swap(x, y);
  }
  return distance;
}

void sort_along_curve(const MshContent& content, std::vector<FileCell>& cells)
{
  std::vector<Vec<2>> centres;
  for (const FileCell& cell : cells) {
    Vec<2> centre{0.0, 0.0};
    for (const Index i : cell.nodes)
      for (int d = 0; d < 2; ++d) centre[d] += 0.25 * content.places[i][d];
    centres.push_back(centre);
  }
  const BoundingBox box = box_around(centres);
  const Real size = std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], std::numeric_limits<Real>::min()});
  const auto on_grid = [&](Real x) { return static_cast<std::uint32_t>(std::clamp(x / size * 65535.0, 0.0, 65535.0)); };
  std::vector<std::pair<std::uint64_t, std::size_t>> order;  // ties in file order
  for (std::size_t k = 0; k < cells.size(); ++k)
    order.emplace_back(hilbert_distance(on_grid(centres[k][0] - box.low[0]), on_grid(centres[k][1] - box.low[1])), k);
  std::ranges::sort(order);
  std::vector<FileCell> sorted;
  sorted.reserve(cells.size());
  for (const auto& [distance, k] : order) sorted.push_back(std::move(cells[k]));
  cells = std::move(sorted);
}

void check_plane(const MshContent& content, const std::vector<Index>& used)
{
  const auto lowest =
      std::ranges::min_element(used, [&](Index a, Index b) { return content.places[a][2] < content.places[b][2]; });
  const auto highest =
      std::ranges::max_element(used, [&](Index a, Index b) { return content.places[a][2] < content.places[b][2]; });
  std::vector<Vec<2>> places;
  for (const Index i : used) places.push_back({content.places[i][0], content.places[i][1]});
  const BoundingBox box = box_around(places);
  const Real size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  const Real low = content.places[*lowest][2], high = content.places[*highest][2];
  if (high - low <= degenerate_share * size) return;
  throw MeshError(
      fmt::format("the mesh does not lie in a plane z = constant: z = {} m at node {}, {} m at node {}\n"
                  "  Draw the section in x and y.",
          coordinate_text(low), content.node_numbers[*lowest], coordinate_text(high), content.node_numbers[*highest]));
}

/// Nodes and cells of the mesh; returns where each node of the file went, or -1.
std::vector<Index> add_nodes_and_cells(const MshContent& content, const std::vector<FileCell>& cells, Mesh<2>& mesh)
{
  std::vector<Index> place(content.places.size(), -1), used;
  for (const FileCell& cell : cells)
    for (const Index i : cell.nodes) place[i] = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] < 0) continue;
    place[k] = mesh.n_nodes();
    used.push_back(static_cast<Index>(k));
    mesh.nodes.push_back({content.places[k][0], content.places[k][1]});
    mesh.node_numbers.push_back(content.node_numbers[k]);
  }
  check_plane(content, used);
  for (const FileCell& cell : cells) {
    std::array<Index, 4> nodes = cell.nodes;
    for (Index& i : nodes) i = place[i];
    mesh.cells.push_back(nodes);
    mesh.cell_numbers.push_back(cell.number);
  }
  return place;
}

std::string name_of_group(const MshContent& content, int dimension, int number)
{
  const auto known = content.group_names.find({dimension, number});
  return known == content.group_names.end() ? fmt::format("{}", number) : known->second;
}

/// Names in order of the groups' numbers, without those that hold nothing.
template <class Named, class Item>
std::vector<Named> named_in_order(
    const MshContent& content, int dimension, const std::map<int, std::vector<Item>>& of_group)
{
  std::vector<Named> all;
  for (const auto& [number, items] : of_group) {
    const std::string name = name_of_group(content, dimension, number);
    auto at = std::ranges::find_if(all, [&](const Named& n) { return n.name == name; });
    if (at == all.end()) at = all.insert(all.end(), Named{name, {}});
    if constexpr (std::is_same_v<Named, NamedSide>)
      at->edges.insert(at->edges.end(), items.begin(), items.end());
    else
      at->cells.insert(at->cells.end(), items.begin(), items.end());
  }
  return all;
}

void add_regions(const MshContent& content, const std::vector<FileCell>& cells, Mesh<2>& mesh)
{
  std::map<int, std::vector<Index>> cells_of_group;
  for (std::size_t e = 0; e < cells.size(); ++e)
    for (const int group : content.group_sets[cells[e].groups]) cells_of_group[group].push_back(static_cast<Index>(e));
  mesh.regions = named_in_order<NamedRegion>(content, 2, cells_of_group);
  for (NamedRegion& region : mesh.regions) {
    std::ranges::sort(region.cells);
    region.cells.erase(std::unique(region.cells.begin(), region.cells.end()), region.cells.end());
  }
}

using EdgeTable = std::map<std::pair<Index, Index>, std::vector<CellSide>>;

EdgeTable cells_of_edges(const Mesh<2>& mesh)
{
  EdgeTable table;
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int s = 0; s < 4; ++s) table[std::minmax(mesh.cells[e][s], mesh.cells[e][(s + 1) % 4])].push_back({e, s});
  return table;
}

struct LineTables {
  const MshContent& content;
  const NodeTable& table;           // of the file's nodes
  const std::vector<Index>& place;  // of the file's nodes in the mesh, or -1
  EdgeTable edges;
};

/// The sides of cells that a line of the file lies on: one on the boundary, two inside; a fault and nothing if it is on
/// none.
const std::vector<CellSide>* sides_of_line(
    const LineTables& tables, const MshElement& line, const std::string& name, MeshFaults& faults)
{
  const Index a = tables.place[tables.table.at(line.nodes[0])], b = tables.place[tables.table.at(line.nodes[1])];
  const auto edge = tables.edges.find(std::minmax(a, b));
  if (edge != tables.edges.end()) return &edge->second;
  faults.add(fmt::format("line {} of side `{}` is not the side of a cell", line.number, name),
      places_of(tables.content, tables.table, line),
      "Physical groups of dimension 1 name parts of the boundary. Take other curves out of them.");
  return nullptr;
}

/// A name of which a line lies inside the mesh bounds nothing.
void add_sides(const LineTables& tables, Mesh<2>& mesh)
{
  std::map<int, std::vector<CellSide>> sides_of_group;
  std::set<std::array<Index, 3>> known;  // group, cell, side: a line may be there twice
  std::set<std::string> inside;
  MeshFaults faults("the mesh");
  for (const MshElement& line : tables.content.lines)
    for (const int group : tables.content.group_sets[line.groups]) {
      const std::string name = name_of_group(tables.content, 1, group);
      const std::vector<CellSide>* sides = sides_of_line(tables, line, name, faults);
      if (sides == nullptr) continue;
      if (sides->size() > 1) inside.insert(name);
      if (known.insert({group, sides->front().cell, sides->front().side}).second)
        sides_of_group[group].push_back(sides->front());
    }
  faults.stop_if_any();
  mesh.sides = named_in_order<NamedSide>(tables.content, 1, sides_of_group);
  for (NamedSide& side : mesh.sides)
    if (inside.contains(side.name)) side = {.name = side.name, .is_inside = true};
}

Mesh<2> make_mesh(const MshContent& content)
{
  const NodeTable table = number_nodes(content);
  refuse_other_elements(content, table);
  refuse_unknown_nodes(content, table);
  std::vector<FileCell> cells = cells_of_quads(content, table);
  turn_clockwise_surfaces(content, cells);
  sort_along_curve(content, cells);
  Mesh<2> mesh;
  const std::vector<Index> place = add_nodes_and_cells(content, cells, mesh);
  check_mesh(mesh);
  add_regions(content, cells, mesh);
  add_sides({content, table, place, cells_of_edges(mesh)}, mesh);
  connect(mesh);
  return mesh;
}

Mesh<2> make_mesh(const std::string& path, const MshContent& content)
{
  try {
    return make_mesh(content);
  } catch (const MeshError& error) {
    throw MeshError(path + ": " + error.what());
  }
}

}  // namespace

Mesh<2> read_gmsh(const std::string& path)
{
  std::string text = contents_of(path);
  return make_mesh(path, needs_conversion(path, text) ? convert_by_gmsh(path) : read_msh(path, std::move(text)));
}

Mesh<2> read_gmsh_text(const std::string& path, std::string text)
{
  return make_mesh(path, read_msh(path, std::move(text)));
}

}  // namespace terp
