// Too many cells are refused by an estimate, before any mesh is made: one wrong unit may ask for more than the memory
// holds. A mesh from a file is the exception: its cells are there already. Afterwards all kinds but the plain rectangle
// are checked, and a fault is reported at the main key of that kind.

#include "model/meshes/setup_mesh.hpp"

#include "math/errors.hpp"
#include "mpm/mesh/box_grid.hpp"
#include "model/meshes/check_mesh.hpp"
#include "model/meshes/generate.hpp"
#include "model/meshes/gmsh_file.hpp"
#include "model/meshes/structured.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real most_cells = 1e5;  // in one direction of the built-in rectangle: beyond, a wrong unit
constexpr Real most_cells_in_all = 2e7;

Index whole_cells(Real size, Real cell)
{
  const Real n = size / cell;
  if (n > most_cells)
    throw InputError(Problem{"mesh.cell", "the mesh has too many cells",
        fmt::format("{:.3g} cells in one direction, at most {:.0f}.", n, most_cells), "mesh", false, {"mesh.size"}});
  return static_cast<Index>(std::round(n));
}

/// key: that makes them so many.
void refuse_too_many(Real n, const std::string& key, const std::string& other)
{
  if (n <= most_cells_in_all) return;
  throw InputError(Problem{key, "the mesh has too many cells",
      fmt::format("About {} cells, at most {:g} million. Lengths are in metres; use larger cells.",
          n < 1e9 ? fmt::format("{:.4g} million", n / 1e6) : fmt::format("{:.3g}", n), most_cells_in_all / 1e6),
      "mesh", false, {other}});
}

void refuse_too_many(const PolygonMesh& mesh)
{
  Real n = estimate_cells(mesh);
  refuse_too_many(n, "mesh.cell", "mesh.polygon");
  for (std::size_t k = 0; k < mesh.refine.size(); ++k) {
    n += estimate_more_cells(mesh, mesh.refine[k]);
    refuse_too_many(n, fmt::format("mesh.refine[{}].cell", k), "mesh.refine");
  }
}

Mesh<2> mesh_from_rectangle(const MeshCase& mesh)
{
  const std::array<Index, 2> n{whole_cells(mesh.size[0], mesh.cell[0]), whole_cells(mesh.size[1], mesh.cell[1])};
  refuse_too_many(static_cast<Real>(n[0]) * n[1], "mesh.cell", "mesh.size");
  return make_rectangle(mesh.origin, mesh.size, n);
}

Mesh<2> mesh_from_polygon(const Case& description)
{
  const MeshCase& mesh = description.mesh;
  PolygonMesh polygon;
  polygon.polygon = mesh.polygon;
  polygon.cell = mesh.cell[0];
  polygon.variant = mesh.variant;
  for (const EdgesCase& e : mesh.edges) polygon.edges.push_back({e.side, e.edges});
  for (const RefineCase& r : mesh.refine) polygon.refine.push_back({r.line, r.low, r.high, r.cell, r.distance});
  if (mesh.follow_bodies)
    for (const BodyCase& body : description.bodies) {
      if (!body.polygon.empty()) polygon.follow.push_back(body.polygon);
      polygon.follow.insert(polygon.follow.end(), body.holes.begin(), body.holes.end());
    }
  refuse_too_many(polygon);
  return generate_mesh(polygon).mesh;
}

Mesh<2> make_mesh(const Case& description)
{
  const MeshCase& mesh = description.mesh;
  if (mesh.kind == MeshKind::graded || mesh.kind == MeshKind::mapped)
    refuse_too_many(static_cast<Real>(mesh.cells[0]) * static_cast<Real>(mesh.cells[1]), "mesh.cells", "mesh");
  switch (mesh.kind) {
    case MeshKind::rectangle: return mesh_from_rectangle(mesh);
    case MeshKind::graded: return make_graded_rectangle(mesh.origin, mesh.size, mesh.cells, mesh.grading);
    case MeshKind::mapped: return make_mapped_rectangle(mesh.sides, mesh.cells, mesh.grading);
    case MeshKind::file: return read_gmsh(path_of(description.folder, mesh.file));
    case MeshKind::polygon: return mesh_from_polygon(description);
  }
  throw InputError(Problem{"mesh", "no such kind of mesh", "", "mesh"});
}

const char* key_of(MeshKind kind)
{
  switch (kind) {
    case MeshKind::mapped: return "mesh.sides";
    case MeshKind::file: return "mesh.file";
    case MeshKind::polygon: return "mesh.polygon";
    default: return "mesh.size";
  }
}

}  // namespace

Mesh<2> build_mesh(const Case& description)
{
  try {
    Mesh<2> mesh = make_mesh(description);
    if (description.mesh.kind != MeshKind::rectangle)
      check_mesh(mesh);  // the built-in rectangle is sound by construction
    return mesh;
  } catch (const MeshError& error) {
    throw InputError(
        Problem{key_of(description.mesh.kind), "the mesh cannot be used", error.what(), "mesh", false, {"mesh"}});
  }
}

Real typical_cell_size(const Mesh<2>& mesh)
{
  Real area = 0.0;
  for (Index e = 0; e < mesh.n_cells(); ++e) area += mesh.geometry(e).volume;
  return std::sqrt(area / static_cast<Real>(mesh.n_cells()));
}

Vec<2> extent_in_x(const Mesh<2>& mesh)
{
  const BoundingBox box = box_around(mesh.nodes);
  return {box.low[0], box.high[0]};
}

}  // namespace terp
