// Soil that is missing: beside the mesh, in holes of the mesh, in voids between the bodies. The area that is drawn is
// that of all outlines together, cut into trapezoids as for the seeding (model/bodies/overlay.hpp). A void is cells
// with little soil that no chain of such cells joins to the air above.

#include "run/findings/missing_soil.hpp"

#include "math/plane.hpp"
#include "model/bodies/overlay.hpp"
#include "model/bodies/setup_points.hpp"
#include "model/loads/side_shape.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "run/findings/soil_size.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

constexpr Real lost_share = 2e-3;  // of the drawn area; curved outlines on straight cells lose less
constexpr std::size_t most_corners = 2000;
constexpr std::size_t most_voids = 3;

/// Area of all drawn polygons together, where they overlap once [m^2]; none if that is not so easily said.
std::optional<Real> drawn_area(const Model& model)
{
  Overlay overlay;
  Vec<2> low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  std::size_t n_corners = 0;
  const auto outlines = outlines_of(model);
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    if (outlines[b].polygon.empty()) return std::nullopt;
    overlay.rings.push_back({outlines[b].polygon, static_cast<Index>(b), false});
    for (const Polygon& hole : outlines[b].holes) overlay.rings.push_back({hole, static_cast<Index>(b), true});
    for (const Vec<2>& x : outlines[b].polygon)
      for (int d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  }
  const Vec<2> middle{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
  const Vec<2> half{0.51 * (high[0] - low[0]), 0.51 * (high[1] - low[1])};
  for (Ring& ring : overlay.rings) {
    n_corners += ring.corners.size();
    for (Vec<2>& x : ring.corners) x = between(middle, x);
  }
  if (n_corners > most_corners) return std::nullopt;
  Real area = 0.0;
  for (const Part& part :
      share_out(overlay, {Vec<2>{-half[0], -half[1]}, {half[0], -half[1]}, {half[0], half[1]}, {-half[0], half[1]}}))
    area += part.area;
  return area;
}

/// A place where a body reaches over the boundary of the mesh.
std::string place_of_loss(const Model& model)
{
  const auto outlines = outlines_of(model);
  for (Index e = 0; e < model.mesh->n_cells(); ++e)
    for (int s = 0; s < 4; ++s) {
      if (model.mesh->neighbours[e][s] != outside) continue;
      const Side edge = edge_of(*model.mesh, {e, s});
      const Vec<2> along = between(edge.a, edge.b), middle = between(edge.a, edge.b, 0.5);
      const Vec<2> beyond = Vec<2>{middle[0] + 0.05 * along[1], middle[1] - 0.05 * along[0]};
      if (std::ranges::any_of(outlines, [&](const BodyOutline& body) { return covers(body, beyond); }))
        return fmt::format(" It reaches over the boundary of the mesh at {} m.", place_text(middle));
    }
  return "";
}

void find_lost_soil(const Model& model, Problems& warnings)
{
  const auto drawn = drawn_area(model);
  Real seeded = 0.0;
  for (const BodyShare& body : model.bodies) seeded += body.area;
  if (!drawn || !(*drawn - seeded > lost_share * *drawn)) return;
  warnings.push_back({"body", "a part of the soil lies outside of the mesh",
      fmt::format("The bodies are drawn with {:.6g} m^2, their points stand for {:.6g} m^2: {:.2g} % is missing.{}\n"
                  "Look for a cell that is missing from the mesh, or make the outline of body and mesh the same.",
          *drawn, seeded, 100.0 * (*drawn - seeded) / *drawn, place_of_loss(model)),
      "mesh", false, {"mesh"}});
}

/// A hole in the mesh that no side names, no larger than a few cells: cells that were forgotten.
void find_holes(const Model& model, Problems& warnings)
{
  constexpr Real few_cells = 4.5;
  const Mesh<2>& mesh = *model.mesh;
  std::vector<Index> next(mesh.nodes.size(), -1);
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int s = 0; s < 4; ++s)
      if (mesh.neighbours[e][s] == outside) next[mesh.cells[e][s]] = mesh.cells[e][(s + 1) % 4];
  for (const NamedSide& side : mesh.sides)
    for (const CellSide& edge : side.edges) next[mesh.cells[edge.cell][edge.side]] = -1;
  const Real cell = typical_cell_size(mesh);
  for (Index start = 0; start < mesh.n_nodes(); ++start) {
    Polygon hole;
    Index i = start;
    while (next[i] >= 0) hole.push_back(mesh.nodes[i]), i = std::exchange(next[i], -1);
    if (hole.empty() || i != start) continue;
    const Real area = -signed_area(hole);
    if (!(area > 0.0) || area > few_cells * cell * cell) continue;
    warnings.push_back({"mesh", "the mesh has a hole",
        fmt::format("At {} m {:.3g} m^2 are missing, about {:.0f} cell{}. Soil cannot enter it, and no side names it.\n"
                    "Add the cell, or name the boundary of the hole.",
            place_text(hole.front()), area, std::max(1.0, area / (cell * cell)), area > 1.5 * cell * cell ? "s" : ""),
        "mesh", false, {"mesh.file"}});
  }
}

void find_tiny_soil(const Model& model, Problems& warnings)
{
  Polygon corners;
  for (const BodyOutline& outline : outlines_of(model))
    corners.insert(corners.end(), outline.polygon.begin(), outline.polygon.end());
  if (corners.empty()) return;
  const BoundingBox box = box_around(corners);
  const Vec<2> soil = between(box.low, box.high);
  const Real cell = typical_cell_size(*model.mesh);
  if (!(std::max(soil[0], soil[1]) < 0.999 * cell) || model.mesh->n_cells() == 1) return;  // one cell: a test of a law
  warnings.push_back({"body", "all bodies together are smaller than a cell",
      fmt::format(
          "They measure {:.3g} m by {:.3g} m, a cell {:.3g} m. Lengths of mesh and bodies are in metres: a mesh in "
          "mm is 1000 times too large.",
          soil[0], soil[1], cell),
      "mesh", false, {"mesh"}});
}

/// Whether a cell has a side at the boundary of the mesh that faces against gravity.
bool meets_the_air(const Mesh<2>& mesh, Index cell, Vec<2> gravity)
{
  constexpr Real up = 0.5;  // cosine
  for (int s = 0; s < Quad4::n_sides; ++s) {
    if (mesh.neighbours[cell][s] != outside) continue;
    const Side edge = edge_of(mesh, {cell, s});
    const Vec<2> along = between(edge.a, edge.b), out{along[1], -along[0]};
    if (-dot(out, gravity) > up * length(out) * length(gravity)) return true;
  }
  return false;
}

/// Voids between bodies, closed on all sides by soil or by the sides of the mesh.
void find_voids(const Model& model, const State& state, Problems& warnings)
{
  const Mesh<2>& mesh = *model.mesh;
  if (model.gravity == Vec<2>{} || state.points.n_points() == 0) return;
  std::vector<bool> seen = cells_of_soil(model, state);
  std::size_t n_voids = 0;
  for (Index start = 0; start < mesh.n_cells(); ++start) {
    if (seen[start]) continue;
    std::vector<Index> part{start};
    seen[start] = true;
    bool open = false;
    Real area = 0.0;
    Polygon places;
    for (std::size_t k = 0; k < part.size(); ++k) {
      open = open || meets_the_air(mesh, part[k], model.gravity);
      area += mesh.geometry(part[k]).volume;
      for (const Index node : mesh.cells[part[k]]) {
        places.push_back(mesh.nodes[node]);
        for (Index c = mesh.first_cell_of_node[node]; c < mesh.first_cell_of_node[node + 1]; ++c)
          if (const Index other = static_cast<Index>(mesh.cells_of_node[c].cell); !seen[other])
            seen[other] = true, part.push_back(other);
      }
    }
    if (open || ++n_voids > most_voids) continue;
    const BoundingBox box = box_around(places);
    warnings.push_back({"body", "there is a void inside the section",
        fmt::format("From x = {:.4g} to {:.4g} m and y = {:.4g} to {:.4g} m some {:.3g} m^2 have no soil, and no way "
                    "to the air: what\nlies above falls. Draw the bodies to each other and to the sides of the mesh.",
            box.low[0], box.high[0], box.low[1], box.high[1], area),
        "body", false, {"body", "mesh"}});
  }
}

}  // namespace

void find_missing_soil(const Model& model, const State& state, Problems& warnings)
{
  find_tiny_soil(model, warnings);
  find_lost_soil(model, warnings);
  find_holes(model, warnings);
  find_voids(model, state, warnings);
}

}  // namespace terp
