// Sides of the mesh that do not lie where their names say, move away from the soil, or do not hold the soil beside
// them.

#include "run/findings/side_warnings.hpp"

#include "math/plane.hpp"
#include "model/loads/side_shape.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "mpm/features/conditions.hpp"
#include "run/findings/soil_size.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

/// The built-in names say where a side lies; edges of a polygon may be counted from 1 or run clockwise.
void find_misplaced_sides(const Model& model, Problems& warnings)
{
  struct Named {
    const char* name;
    Vec<2> normal;
    const char* place;
  };
  constexpr Named known[] = {{"left", {-1.0, 0.0}, "to the left"}, {"right", {1.0, 0.0}, "to the right"},
      {"bottom", {0.0, -1.0}, "downward"}, {"top", {0.0, 1.0}, "upward"}};
  const auto facing = [](Vec<2> n, const Named& side) { return n[0] * side.normal[0] + n[1] * side.normal[1]; };
  constexpr Real faces = 0.25;  // cosine: a slope of 1:4 may be the left side
  for (const NamedSide& side : model.mesh->sides)
    for (const Named& named : known) {
      const SideShape shape = shape_of_side(*model.mesh, side);
      if (side.name != named.name || shape.length == 0.0 || facing(shape.normal, named) >= faces) continue;
      const Named* looks = std::ranges::max_element(
          known, [&](const Named& a, const Named& b) { return facing(shape.normal, a) < facing(shape.normal, b); });
      const MeshKind kind = model.description.mesh.kind;
      const bool polygon = kind == MeshKind::polygon, file = kind == MeshKind::file;
      const std::string key = polygon ? fmt::format("mesh.edges.\"{}\"", side.name) : file ? "mesh.file" : "mesh.sides";
      warnings.push_back({key, fmt::format("the side `{}` does not face {}", side.name, named.place),
          fmt::format("It faces {}, {:.4g} m long. {}", looks->place, shape.length,
              polygon ? "Edge k runs from corner k of the polygon to corner k + 1, counted from 0.\n"
                        "`terp check CASE --picture section.svg` draws it."
              : file  ? "Look at the physical group of that name in the mesh file, or give the side another name."
                      : "Look at the order of the four lines of the grid."),
          polygon ? "mesh.edges" : "mesh", false, {"mesh.polygon", "mesh"}});
    }
}

void find_sides_that_move_far(const Model& model, std::vector<Problem>& warnings)
{
  for (const SideCondition& side : model.description.sides) {
    Real speed = 0.0;
    for (const CellSide& edge : find_side(*model.mesh, side.side).edges) {
      const Vec<2> v = velocity_of(side, model.mesh->nodes[model.mesh->cells[edge.cell][edge.side]]);
      speed = std::max(speed, std::hypot(v[0], v[1]));
    }
    const Real distance = speed * model.description.time.end;
    if (!(distance > model.mesh->smallest_altitude)) continue;
    warnings.push_back({fmt::format("boundary.\"{}\".velocity", side.side),
        "the side stays in place: it pushes soil over one cell at most",
        fmt::format("Its velocity times time.end is {:.4g} m, the smallest cell is {:.4g} m high. The mesh does not "
                    "move with the side:\n"
                    "soil that has left the cells next to it is pushed no more.",
            distance, model.mesh->smallest_altitude),
        "boundary.SIDE.velocity"});
  }
}

/// Soil against an upright side that nothing holds, over more than a few cells: it leans on air. The sides of the mesh
/// at its left and right ends count; a face in the section is the soil's own.
void find_free_sides(
    const Model& model, const State& state, const Case& now, const std::string& stage, Problems& warnings)
{
  constexpr Real upright = 0.9, fewest_cells = 2.0;
  const Mesh<2>& mesh = *model.mesh;
  const Real g = length(model.gravity);
  if (!(-model.gravity[1] > std::abs(model.gravity[0]))) return;
  const auto holds = [&](const SideCondition& side) {  // against a push to the side
    const SideShape shape = shape_of_side(mesh, find_side(mesh, side.side));
    return info_of(side.kind).action.across != Across::free && std::abs(shape.normal[0]) > std::abs(shape.normal[1]);
  };
  if (now.initial.stress == InitialStress::none && std::ranges::none_of(now.sides, holds))
    return;  // it is meant to run out
  const std::vector<bool> soil = cells_of_soil(model, state);
  for (const NamedSide& side : mesh.sides) {
    if (info_of(condition_of(now, side.name).kind).action != SideAction{}) continue;
    Real height = 0.0, low = INFINITY, high = -INFINITY;
    for (const CellSide& at : side.edges) {
      const Side edge = edge_of(mesh, at);
      const Vec<2> along = between(edge.a, edge.b);
      const Real rise = std::abs(dot(along, model.gravity)) / g;
      if (mesh.neighbours[at.cell][at.side] != outside || rise < upright * length(along) || !soil[at.cell]) continue;
      height += rise;
      low = std::min({low, edge.a[1], edge.b[1]}), high = std::max({high, edge.a[1], edge.b[1]});
    }
    if (!(height > fewest_cells * typical_cell_size(mesh))) continue;
    warnings.push_back({stage.empty() ? fmt::format("boundary.\"{}\"", side.name) : stage,
        fmt::format("soil leans on the side `{}`, which is free", side.name),
        fmt::format("It does so over {:.3g} m, from y = {:.4g} to {:.4g} m. A free side carries nothing: soil runs out "
                    "there. Give it\n\"roller\", or room beside the soil.",
            height, low, high),
        "boundary", false, {"boundary", "mesh"}});
  }
}

}  // namespace

void find_odd_sides(const Model& model, const State& state, Problems& warnings)
{
  find_misplaced_sides(model, warnings);
  find_sides_that_move_far(model, warnings);
  const std::size_t before = warnings.size();
  find_free_sides(model, state, model.description, "", warnings);
  const Case& whole = model.whole();
  for (std::size_t k = 0; k < whole.stages.size() && warnings.size() == before; ++k)
    if (whole.stages[k].changed)
      find_free_sides(model, state, *whole.stages[k].changed, fmt::format("stage[{}].set", k), warnings);
}

}  // namespace terp
