// Each frame holds the mesh again with its values, since every frame is a file of its own that needs no other one.
// mesh.vtkhdf is written under a temporary name and then moved, so that a reader never finds half of it. The mesh does
// not change in a run, so an existing mesh.vtkhdf is kept.

#include "io/files/mesh_file.hpp"

#include "io/files/hdf5_file.hpp"
#include "io/files/run_folder.hpp"
#include "math/errors.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace terp {
namespace {

using namespace vtkhdf;

constexpr std::uint8_t vtk_quad = 9;  // VTK_QUAD of vtkCellType.h
constexpr int n_corners = 4;
constexpr std::int64_t n_datasets = 12;

/// Bytes of places, cells and fields, were they not compressed.
std::int64_t largest_size(const Mesh<2>& mesh)
{
  return 8 * (6 * mesh.n_nodes() + 4 * mesh.n_cells()) + n_datasets * hdf5_header_bytes;
}

void write_grid(Hdf5File& file, const Mesh<2>& mesh)
{
  const std::int64_t n_nodes = mesh.n_nodes(), n_cells = mesh.n_cells();
  write_sizes(file, n_nodes, n_cells, n_corners * n_cells);
  write_rows<Real>(file, root + "/Points", {n_nodes, 3}, exact, [&](std::size_t k, std::vector<Real>& x) {
    x.insert(x.end(), {mesh.nodes[k][0], mesh.nodes[k][1], 0.0});
  });
  file.set_text(root + "/Points", "unit", "m");
  write_rows<std::int64_t>(file, root + "/Connectivity", {n_corners * n_cells}, whole,
      [&](std::size_t k, auto& nodes) { nodes.push_back(mesh.cells[k / n_corners][k % n_corners]); });
  write_rows<std::int64_t>(file, root + "/Offsets", {n_cells + 1}, whole,
      [](std::size_t k, auto& offsets) { offsets.push_back(static_cast<std::int64_t>(n_corners * k)); });
  write_rows<std::uint8_t>(
      file, root + "/Types", {n_cells}, exact, [](std::size_t, auto& types) { types.push_back(vtk_quad); });
}

}  // namespace

void write_mesh(const std::string& path, const Mesh<2>& mesh, const std::string& run)
{
  TemporaryFile place(path);
  Hdf5File file(place.name(), Hdf5File::Mode::create, largest_size(mesh));
  write_head(file, run);
  write_grid(file, mesh);
  file.close();
  place.move_into_place();
}

Mesh<2> read_mesh(const std::string& path)
{
  const Hdf5File file(path, Hdf5File::Mode::read);
  const std::vector<Real> places = file.read<Real>(root + "/Points");
  const std::vector<std::int64_t> corners = file.read<std::int64_t>(root + "/Connectivity");
  Mesh<2> mesh;
  for (std::size_t k = 0; k + 2 < places.size(); k += 3) mesh.nodes.push_back({places[k], places[k + 1]});
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (corners[k] < 0 || corners[k] >= mesh.n_nodes())
      throw FileError(fmt::format("{} is damaged: a cell has the node {}", path, corners[k]));
    if (k % n_corners == 0) mesh.cells.emplace_back();
    mesh.cells.back()[k % n_corners] = static_cast<Index>(corners[k]);
  }
  if (mesh.cells.empty() || corners.size() % n_corners != 0)
    throw FileError(fmt::format("{} is damaged: it has no whole cells", path));
  connect(mesh);
  return mesh;
}

MeshWriter::MeshWriter(const std::string& folder, FrameSeries& frames, const Model& model, const State& state)
    : frames_(frames), model_(model), state_(state)
{
  const std::string path = path_in(folder, mesh_file);
  if (!std::filesystem::exists(path)) write_mesh(path, *model.mesh, frames_.run());
}

void MeshWriter::frame(const std::shared_ptr<const Frame>&)
{
  if (!model_.description.output.mesh || state_.step == last_step_) return;
  last_step_ = state_.step;
  const MeshFrame values = make_mesh_frame(model_, state_);
  Hdf5File& file = frames_.begin(values.time, values.step, largest_size(*model_.mesh));
  write_grid(file, *model_.mesh);
  const std::int64_t n_nodes = model_.mesh->n_nodes(), n_cells = model_.mesh->n_cells();
  write_field(file, {root + "/PointData/mass", "kg per m", 1, n_nodes, 0}, values.mass, exact);
  write_field(file, {root + "/PointData/velocity", "m/s", 2, n_nodes, 0}, values.velocity, exact);
  write_field(file, {root + "/CellData/pressure", "Pa", 1, n_cells, 0}, values.pressure, exact);
  frames_.end();
}

}  // namespace terp
