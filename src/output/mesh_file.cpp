// mesh.vtkhdf in the VTKHDF format 2.0: nodes and cells are written once, fields of nodes and cells frame after frame.
#include "output/mesh_file.hpp"

#include "output/committed_file.hpp"
#include "output/files.hpp"
#include "output/run_folder.hpp"
#include "output/vtkhdf_steps.hpp"

#include <filesystem>

namespace terp {
namespace {

using vtkhdf::root;
using vtkhdf::steps;

constexpr std::uint8_t vtk_quad = 9;              // VTK_QUAD of vtkCellType.h
constexpr int compression = 1;
constexpr std::int64_t header_bytes = 16 << 10;   // of one table
constexpr int n_tables = 25;
constexpr std::int64_t largest_chunk = 1 << 15;   // rows

/// A field, its group and how many components it has.
struct MeshField {
  const char* data;  ///< "PointData" or "CellData"
  const char* name;
  const char* unit;
  int n_components;
};

constexpr MeshField mass{"PointData", "mass", "kg per m", 1}, velocity{"PointData", "velocity", "m/s", 2}, pressure{"CellData", "pressure", "Pa", 1};
constexpr std::array fields{mass, velocity, pressure};

std::string table_of(const MeshField& field) { return root + "/" + field.data + "/" + field.name; }

std::string offsets_of(const MeshField& field) { return steps + "/" + field.data + "Offsets/" + field.name; }

/// Bytes of places, cells and one frame, were they not compressed.
std::int64_t largest_size(std::int64_t n_nodes, std::int64_t n_cells) { return 8 * (8 * n_nodes + 8 * n_cells) + n_tables * header_bytes; }

std::int64_t count_of(const Hdf5File& file, const char* data)
{
  return file.read<std::int64_t>(root + (data == std::string_view("CellData") ? "/NumberOfCells" : "/NumberOfPoints")).at(0);
}

template <class T>
void add_table(Hdf5File& file, const std::string& name, int n_columns, const std::vector<T>& values)
{
  const std::int64_t n_rows = std::ssize(values) / std::max(1, n_columns);
  file.create_table<T>(name, {n_columns, std::min(n_rows, largest_chunk), compression});
  file.write_rows<T>(name, 0, values);
}

void add_grid(Hdf5File& file, const Mesh<2>& mesh)
{
  std::vector<Real> places;
  for (const Vec<2>& x : mesh.nodes) places.insert(places.end(), {x[0], x[1], 0.0});
  add_table(file, root + "/Points", 3, places);
  file.set_text(root + "/Points", "unit", "m");

  std::vector<std::int64_t> connectivity, offsets{0};
  for (const auto& cell : mesh.cells) {
    connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    offsets.push_back(std::ssize(connectivity));
  }
  add_table(file, root + "/Connectivity", 0, connectivity);
  add_table(file, root + "/Offsets", 0, offsets);
  add_table(file, root + "/Types", 0, std::vector<std::uint8_t>(mesh.cells.size(), vtk_quad));
  const auto number = [&](const char* name, std::int64_t n) { file.write<std::int64_t>(root + "/" + name, {1}, std::vector<std::int64_t>{n}); };
  number("NumberOfPoints", mesh.n_nodes());
  number("NumberOfCells", mesh.n_cells());
  number("NumberOfConnectivityIds", std::ssize(connectivity));
}

void add_fields(Hdf5File& file, const Mesh<2>& mesh)
{
  file.create_group(steps);
  for (const char* data : {"PointData", "CellData"}) {
    file.create_group(root + "/" + data);
    file.create_group(steps + "/" + data + "Offsets");
  }
  vtkhdf::add_steps(file);
  const std::int64_t n_rows = std::max(mesh.n_nodes(), mesh.n_cells());
  for (const MeshField& field : fields) {
    file.create_table<Real>(table_of(field), {vtkhdf::n_columns(field.n_components), std::min(n_rows, largest_chunk), compression});
    vtkhdf::describe_field(file, table_of(field), field.unit, field.n_components);
    file.create_table<std::int64_t>(offsets_of(field), {});
  }
}

void write_field(Hdf5File& file, const MeshField& field, std::int64_t k, const std::vector<Real>& values)
{
  const std::int64_t first_row = k * count_of(file, field.data);
  file.write_rows<Real>(table_of(field), first_row, field.n_components == 2 ? vtkhdf::with_z(values) : values);
  vtkhdf::write_integer(file, offsets_of(field), k, first_row);
}

}  // namespace

void MeshFile::create(const Mesh<2>& mesh, bool with_steps) const
{
  write_whole(path_, [&](const std::string& temporary) {
    Hdf5File file(temporary, Hdf5File::Mode::create, largest_size(mesh.n_nodes(), mesh.n_cells()));
    file.create_group(root);
    vtkhdf::add_header(file);
    add_grid(file, mesh);
    if (with_steps) add_fields(file, mesh);
    file.close();
  });
}

void MeshFile::append(const MeshFrame& frame) const
{
  Hdf5File file(path_, Hdf5File::Mode::commit, largest_size(std::ssize(frame.mass), std::ssize(frame.pressure)));
  const std::int64_t k = file.integers(steps, "NSteps").at(0);
  write_field(file, mass, k, frame.mass);
  write_field(file, velocity, k, frame.velocity);
  write_field(file, pressure, k, frame.pressure);
  vtkhdf::write_step(file, k, frame.time, frame.step, 0);
  file.set_integers(steps, "NSteps", {k + 1});
  file.close();
}

std::int64_t MeshFile::count_until(std::int64_t step) const
{
  finish_commit(path_);
  if (!std::filesystem::exists(path_)) return 0;
  const Hdf5File file(path_, Hdf5File::Mode::read);
  return file.exists(steps) ? vtkhdf::count_steps(file, step) : 0;
}

void MeshFile::truncate_after(std::int64_t step) const
{
  if (!std::filesystem::exists(path_) || !Hdf5File(path_, Hdf5File::Mode::read).exists(steps)) return;
  Hdf5File file(path_, Hdf5File::Mode::commit, largest_size(largest_chunk, largest_chunk));
  std::vector<vtkhdf::StepTable> tables;
  for (const MeshField& field : fields) tables.push_back({table_of(field), count_of(file, field.data)});
  vtkhdf::cut_steps(file, step, tables);
  file.close();
}

MeshWriter::MeshWriter(const std::string& folder, const Model& model, const State& state)
    : file_(path_in(folder, mesh_file)), model_(model), state_(state)
{
  if (!std::filesystem::exists(path_in(folder, mesh_file))) file_.create(model.mesh, model.description.output.mesh);
}

void MeshWriter::frame(const std::shared_ptr<const Frame>&)
{
  if (!model_.description.output.mesh || state_.step == last_step_) return;
  file_.append(make_mesh_frame(model_, state_));
  last_step_ = state_.step;
}

}  // namespace terp
