// The keys that are given decide the kind of mesh. Keys of another kind are named first, and then only the checks of
// that kind run. Their order matters for a grid between four sides: its direction is known only where the sides meet.
// Edges of a polygon keep the numbers of the user until all checks are done, and only then may the polygon be turned.

#include "io/case/check_case.hpp"

#include "math/plane.hpp"
#include "io/case/mesh_kinds.hpp"
#include "io/case/units.hpp"
#include "model/bodies/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

constexpr Real rounded = 1e-6;  // relative: the file holds rounded decimals

/// Keys of another kind of mesh than the one that the others speak of.
void check_kind(const Node& mesh, Problems& problems)
{
  const MeshKindInfo& kind = mesh_kind_of(mesh);
  std::vector<std::string> foreign;
  for (const Node& item : mesh.items) {
    const auto takes = [&](const MeshKindInfo& other) { return is_allowed(other, item.name); };
    const bool is_known = std::ranges::any_of(all_mesh_kinds(), takes);
    if (is_known && !is_allowed(kind, item.name)) foreign.push_back(item.name);
  }
  if (foreign.empty()) return;
  std::string names;
  for (const std::string& name : foreign) names += (names.empty() ? "`" : ", `") + name + '`';
  problems.push_back({"mesh." + foreign.front(),
      fmt::format("{} {} not belong to {}", names, foreign.size() == 1 ? "does" : "do", kind.meaning),
      "Keys that belong together:\n" + mesh_kinds_text("  "), "mesh", true});
}

void check_cells(const MeshCase& mesh, Problems& problems)
{
  const char* const words[] = {"width", "height"};
  for (int k = 0; k < 2; ++k) {
    const Real size = mesh.size[k], cell = mesh.cell[k];
    if (!(size > 0.0) || !(cell > 0.0)) continue;
    const Real n = size / cell;
    if (n >= 0.5 && std::abs(n - std::round(n)) <= rounded) continue;
    const Real fits = size / std::max(std::round(n), 1.0);
    problems.push_back({"mesh.cell", fmt::format("the {} of the mesh is not a whole number of cells", words[k]),
        fmt::format("{} m / {} m = {:.6g}; the nearest {} that fits is {:.6g} m.", size, cell, n, words[k], fits),
        "mesh.cell", false, {"mesh.size"}});
  }
}

struct GridCorner {
  int side, other;       ///< in the order of MeshCase::sides
  bool at_end, at_last;  ///< of the first, of the second: its last place, otherwise its first
};

bool check_sides_meet(const MeshCase& mesh, Problems& problems)
{
  const char* const names[] = {"bottom", "right", "top", "left"};
  const auto end_of = [&](int side, bool last) { return last ? mesh.sides[side].back() : mesh.sides[side].front(); };
  const auto is_there = [](const std::vector<Vec<2>>& side) { return side.size() >= 2; };
  if (!std::ranges::all_of(mesh.sides, is_there)) return false;
  const Real scale = distance(end_of(0, false), end_of(2, true)) + distance(end_of(0, true), end_of(2, false));
  for (const auto& [side, other, at_end, at_last] :
      {GridCorner{0, 3, false, false}, {0, 1, true, false}, {2, 1, true, true}, {2, 3, false, true}}) {
    const Vec<2> a = end_of(side, at_end), b = end_of(other, at_last);
    if (distance(a, b) <= rounded * scale) continue;
    problems.push_back({fmt::format("mesh.sides.{}", names[other]),
        fmt::format("`{}` and `{}` do not meet", names[side], names[other]),
        fmt::format("`{}` {} at ({}, {}) m, `{}` {} at ({}, {}) m.\n"
                    "Write bottom and top from left to right, left and right from bottom to top.",
            names[side], at_end ? "ends" : "starts", a[0], a[1], names[other], at_last ? "ends" : "starts", b[0], b[1]),
        "mesh.sides"});
    return false;  // one end out of place often pulls others along
  }
  return true;
}

/// Around the grid: along bottom, right, then back along top and left.
void check_sides_turn(const MeshCase& mesh, Problems& problems)
{
  const auto& [bottom, right, top, left] = mesh.sides;
  std::vector<Vec<2>> loop = bottom;
  loop.insert(loop.end(), right.begin(), right.end());
  loop.insert(loop.end(), top.rbegin(), top.rend());
  loop.insert(loop.end(), left.rbegin(), left.rend());
  if (signed_area(loop) > 0.0) return;
  problems.push_back({"mesh.sides", "the four sides run clockwise",
      "Seen along bottom, the grid must lie to the left. Exchange left and right and write bottom and "
      "top the other way round.",
      "mesh.sides", true});
}

void check_polygon(const Node& table, const MeshCase& mesh, Problems& problems)
{
  const Node* cell = find_item(table, "cell");
  if (cell != nullptr && cell->kind == NodeKind::list)
    problems.push_back({"mesh.cell", "`cell` must be one number for a mesh from a polygon",
        "It is the size that gmsh aims at in every direction.", "mesh.cell"});
  const std::size_t n = mesh.polygon.size();
  for (std::size_t k = 0; k < n; ++k)
    if (mesh.polygon[k] == mesh.polygon[(k + 1) % n])
      problems.push_back(
          {fmt::format("mesh.polygon[{}]", (k + 1) % n == 0 ? k : k + 1), "two corners of the polygon are the same",
              "Name each corner once; the last edge closes the polygon by itself.", "mesh.polygon"});
}

void check_edges(const MeshCase& mesh, Problems& problems)
{
  const auto n = static_cast<Index>(mesh.polygon.size());
  std::map<Index, std::string> owner;
  for (const auto& [side, edges] : mesh.edges)
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const std::string path = fmt::format("{}[{}]", join_path("mesh.edges", side), k);
      if (n > 0 && edges[k] >= n)
        problems.push_back({path, fmt::format("the polygon has no edge {}", edges[k]),
            fmt::format("It has {0} corners and so the edges 0 to {1}; edge k runs from corner k to "
                        "corner k + 1, edge {1} back to corner 0.",
                n, n - 1),
            "mesh.edges", false, {"mesh.polygon"}});
      const auto [first, is_new] = owner.emplace(edges[k], side);
      if (!is_new)
        problems.push_back({path, fmt::format("the edge {} is named twice", edges[k]),
            first->second == side
                ? fmt::format("Both times in `{}`.", side)
                : fmt::format("In `{}` and in `{}`; an edge is part of one side only.", first->second, side),
            "mesh.edges"});
    }
}

void check_refinement(const Node& table, const RefineCase& refine, const std::string& path, Problems& problems)
{
  const bool line = find_item(table, "line") != nullptr, box = find_item(table, "box") != nullptr;
  if (line && box)
    problems.push_back({path + ".box", "a refinement has either `line` or `box`, not both",
        "Remove one of the two, or write two refinements.", "mesh.refine", true});
  if (!line && !box)
    problems.push_back({path, "the refinement has no place",
        "Give line = [[x, y], [x, y], ...] or box = [[x0, y0], [x1, y1]] in m.", "mesh.refine", true});
  const Node* distance = find_item(table, "distance");
  const bool is_zero = distance != nullptr && number_of(*distance, "m") && refine.distance == 0.0;
  if (line && !box && (distance == nullptr || is_zero))
    problems.push_back({distance == nullptr ? path : path + ".distance", "a line needs a `distance`",
        "Give the distance in m, more than 0, over which the cells grow back to mesh.cell.", "mesh.refine.distance",
        distance == nullptr});
}

void check_refinements(const Node& mesh_table, const MeshCase& mesh, Findings& findings)
{
  const Node* list = find_item(mesh_table, "refine");
  for (std::size_t k = 0; k < mesh.refine.size(); ++k) {
    const std::string path = fmt::format("mesh.refine[{}]", k);
    if (list->items[k].kind == NodeKind::table)
      check_refinement(list->items[k], mesh.refine[k], path, findings.problems);
    if (mesh.cell[0] > 0.0 && mesh.refine[k].cell >= mesh.cell[0])
      findings.warnings.push_back({path + ".cell", "the refinement has no effect",
          fmt::format("Its cells of {} m are not smaller than mesh.cell = {} m.", mesh.refine[k].cell, mesh.cell[0]),
          "mesh.refine"});
  }
}

}  // namespace

void check_mesh(const Node& root, const MeshCase& mesh, Findings& findings)
{
  const Node* table = find_item(root, "mesh");
  if (table == nullptr || table->kind != NodeKind::table) return;
  check_kind(*table, findings.problems);
  if (mesh.kind == MeshKind::rectangle) check_cells(mesh, findings.problems);
  if (mesh.kind == MeshKind::mapped && check_sides_meet(mesh, findings.problems))
    check_sides_turn(mesh, findings.problems);
  if (mesh.kind != MeshKind::polygon) return;
  check_polygon(*table, mesh, findings.problems);
  check_edges(mesh, findings.problems);
  check_refinements(*table, mesh, findings);
}

void turn_counter_clockwise(MeshCase& mesh)
{
  if (signed_area(mesh.polygon) >= 0.0) return;
  std::ranges::reverse(mesh.polygon);
  const auto n = static_cast<Index>(mesh.polygon.size());
  for (EdgesCase& side : mesh.edges)  // corner k is now n - 1 - k, so the edge from k to k + 1 starts at n - 2 - k
    for (Index& edge : side.edges) edge = (2 * n - 2 - edge) % n;
}

}  // namespace terp
