// mesh.vtkhdf in the VTKHDF format 2.0: nodes and cells are written once, fields of nodes and cells frame after frame.
#include "output/mesh_file.hpp"

#include "output/checksum.hpp"
#include "output/committed_file.hpp"
#include "output/files.hpp"
#include "output/run_folder.hpp"
#include "output/vtkhdf_steps.hpp"

#include <filesystem>

namespace terp {
namespace {

using vtkhdf::root;
using vtkhdf::steps;

constexpr std::uint8_t vtk_quad = 9;  // VTK_QUAD of vtkCellType.h
constexpr int compression = 1;
constexpr std::int64_t header_bytes = 16 << 10;  // of one table
constexpr int n_tables = 25;
constexpr std::int64_t largest_chunk = 1 << 15;  // rows

/// A field, its group and how many components it has.
struct MeshField {
  const char* data;  ///< "PointData" or "CellData"
  const char* name;
  const char* unit;
  int n_components;
};

constexpr MeshField mass{"PointData", "mass", "kg per m", 1}, velocity{"PointData", "velocity", "m/s", 2},
    pressure{"CellData", "pressure", "Pa", 1};
constexpr std::array fields{mass, velocity, pressure};

std::string table_of(const MeshField& field) { return root + "/" + field.data + "/" + field.name; }

std::string offsets_of(const MeshField& field) { return steps + "/" + field.data + "Offsets/" + field.name; }

/// Bytes of places, cells and one frame, were they not compressed.
std::int64_t largest_size(std::int64_t n_nodes, std::int64_t n_cells)
{
  return 8 * (8 * n_nodes + 8 * n_cells) + n_tables * header_bytes;
}

std::int64_t count_of(const Hdf5File& file, const char* data)
{
  return file.read_rows<std::int64_t>(
      root + (data == std::string_view("CellData") ? "/NumberOfCells" : "/NumberOfPoints"), 0, 1)[0];
}

/// A table of n_rows; add_row(k, values) appends row k. A part at a time: all of a large mesh would be the most memory
/// that a run ever takes.
template <class T, class F>
void add_table(Hdf5File& file, const std::string& name, int n_columns, std::int64_t n_rows, F&& add_row)
{
  file.create_table<T>(name, {n_columns, std::min(n_rows, largest_chunk), compression});
  std::vector<T> values;
  for (std::int64_t first = 0; first < n_rows; first += largest_chunk) {
    values.clear();
    for (std::int64_t k = first; k < std::min(first + largest_chunk, n_rows); ++k)
      add_row(static_cast<std::size_t>(k), values);
    file.write_rows<T>(name, first, values);
  }
}

void add_grid(Hdf5File& file, const Mesh<2>& mesh)
{
  constexpr std::size_t n_corners = 4;
  const std::int64_t n_corners_of_all = static_cast<std::int64_t>(n_corners) * mesh.n_cells();
  add_table<Real>(file, root + "/Points", 3, mesh.n_nodes(), [&](std::size_t k, std::vector<Real>& places) {
    places.insert(places.end(), {mesh.nodes[k][0], mesh.nodes[k][1], 0.0});
  });
  file.set_text(root + "/Points", "unit", "m");
  using Integers = std::vector<std::int64_t>;
  add_table<std::int64_t>(file, root + "/Connectivity", 0, n_corners_of_all,
      [&](std::size_t k, Integers& nodes) { nodes.push_back(mesh.cells[k / n_corners][k % n_corners]); });
  add_table<std::int64_t>(file, root + "/Offsets", 0, mesh.n_cells() + 1,
      [](std::size_t k, Integers& offsets) { offsets.push_back(static_cast<std::int64_t>(n_corners * k)); });
  add_table<std::uint8_t>(file, root + "/Types", 0, mesh.n_cells(),
      [](std::size_t, std::vector<std::uint8_t>& types) { types.push_back(vtk_quad); });
  const auto number = [&](const char* name, std::int64_t n) {
    file.write<std::int64_t>(root + "/" + name, {1}, std::vector<std::int64_t>{n});
  };
  number("NumberOfPoints", mesh.n_nodes());
  number("NumberOfCells", mesh.n_cells());
  number("NumberOfConnectivityIds", n_corners_of_all);
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
    file.create_table<Real>(
        table_of(field), {vtkhdf::n_columns(field.n_components), std::min(n_rows, largest_chunk), compression});
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
    vtkhdf::add_header(file, run_);
    add_grid(file, mesh);
    if (with_steps) add_fields(file, mesh);
    file.close();
  });
}

void MeshFile::append(const MeshFrame& frame) const
{
  Hdf5File file(path_, Hdf5File::Mode::commit, largest_size(std::ssize(frame.mass), std::ssize(frame.pressure)));
  const std::int64_t k = file.integer(steps, "NSteps");
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

std::unique_ptr<Hdf5File> MeshFile::open_to_cut() const
{
  if (!std::filesystem::exists(path_)) return nullptr;
  return std::make_unique<Hdf5File>(path_, Hdf5File::Mode::commit, largest_size(largest_chunk, largest_chunk));
}

void MeshFile::cut_after(Hdf5File& file, std::int64_t step)
{
  if (!file.exists(steps)) return;
  std::vector<vtkhdf::StepTable> tables;
  for (const MeshField& field : fields)
    tables.push_back({table_of(field), count_of(file, field.data), vtkhdf::n_columns(field.n_components)});
  vtkhdf::cut_steps(file, step, tables);
}

MeshWriter::MeshWriter(
    const std::string& folder, const std::string& case_record, const Model& model, const State& state)
    : file_(path_in(folder, mesh_file), digits_of(case_record)), model_(model), state_(state)
{
  if (!std::filesystem::exists(path_in(folder, mesh_file))) file_.create(*model.mesh, model.description.output.mesh);
}

void MeshWriter::frame(const std::shared_ptr<const Frame>&)
{
  if (!model_.description.output.mesh || state_.step == last_step_) return;
  file_.append(make_mesh_frame(model_, state_));
  last_step_ = state_.step;
}

}  // namespace terp
