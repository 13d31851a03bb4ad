#include "model/meshes/turned_mesh.hpp"

#include "model/meshes/mesh_error.hpp"
#include "model/meshes/generate.hpp"

namespace terp {
namespace {

PolygonMesh outline_of(const MeshCase& mesh)
{
  PolygonMesh outline;
  outline.cell = mesh.cell[0];
  if (mesh.kind == MeshKind::polygon) {
    outline.polygon = mesh.polygon;
    outline.variant = mesh.variant;
    for (const EdgesCase& e : mesh.edges) outline.edges.push_back({e.side, e.edges});
    return outline;
  }
  const auto [x, y] = mesh.origin;
  const auto [width, height] = mesh.size;
  outline.polygon = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
  outline.edges = {{"bottom", {0}}, {"right", {1}}, {"top", {2}}, {"left", {3}}};
  return outline;
}

}  // namespace

std::string why_not_turned(const Case& description)
{
  const MeshCase& mesh = description.mesh;
  switch (mesh.kind) {
    case MeshKind::rectangle: return mesh.cell[0] == mesh.cell[1] ? "" : "its cells are no squares";
    case MeshKind::graded: return "it is a graded rectangle";
    case MeshKind::mapped: return "it is a grid between four sides";
    case MeshKind::file: return "it is a file of its own";
    case MeshKind::polygon: break;
  }
  if (!mesh.refine.empty()) return "it is refined";
  return mesh.follow_bodies ? "its cells follow the bodies (mesh.follow_bodies = false makes them free)" : "";
}

std::string turned_mesh_file(const Case& description, Real turn)
{
  PolygonMesh outline = outline_of(description.mesh);
  outline.turn = turn;
  const std::string path = generate_mesh(outline).path;
  if (path.empty()) throw MeshError("the turned mesh cannot be kept: its folder cannot be written (XDG_CACHE_HOME)");
  return path;
}

}  // namespace terp
