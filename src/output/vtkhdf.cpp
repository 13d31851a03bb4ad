// results.vtkhdf in the VTKHDF format 2.0, type UnstructuredGrid, temporal: one vertex cell per material point.
//
// The cells are the same in all frames: Connectivity, Offsets, Types and the sizes are written once, and PartOffsets,
// CellOffsets and ConnectivityIdOffsets are 0 in every step. (VTK starts reading Offsets at CellOffsets + PartOffsets,
// so a part per step would need the cells once per step.) Points and fields of the frames follow each other.
#include "output/vtkhdf.hpp"

#include "base/errors.hpp"
#include "output/committed_file.hpp"
#include "output/files.hpp"
#include "output/vtkhdf_steps.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr int compression = 1;                   // level 3: half a per cent smaller, a quarter slower (docs/formats.md)
constexpr std::int64_t chunk_bytes = 1 << 20;    // HDF5's default chunk cache
constexpr std::int64_t header_bytes = 16 << 10;  // more than a table's headers and index grow by in one frame
constexpr std::int64_t cutting_bytes = 16 << 20;  // a rewritten chunk for each of 16 fields
constexpr std::uint8_t vtk_vertex = 1;            // VTK_VERTEX of vtkCellType.h

using namespace vtkhdf;

const std::string point_data = root + "/PointData";
const std::string point_data_offsets = steps + "/PointDataOffsets";

/// At least what n points of a frame, or of the cells, take in the file, should they not compress at all.
std::int64_t largest_size(const Frame& frame, std::int64_t n)
{
  const std::int64_t n_tables = 15 + 2 * std::ssize(frame.fields);
  std::int64_t n_values = 4 * n;  // places; Offsets, Connectivity, Types and id take less
  for (const auto& field : frame.fields) n_values += n * std::max(1, n_columns(field.n_components));
  return n_values * std::int64_t{sizeof(Real)} + n_tables * header_bytes;
}

/// Chunks of equal size that fill a frame and stay within chunk_bytes.
Hdf5File::TableLayout point_layout(std::int64_t n_rows, int n_columns)
{
  const std::int64_t row_bytes = std::max(1, n_columns) * std::int64_t{sizeof(Real)};
  const std::int64_t n_chunks = n_rows * row_bytes / chunk_bytes + 1;
  return {n_columns, (n_rows + n_chunks - 1) / n_chunks, compression};
}

/// Of a frame that comes in parts, chunks small against a part: one that two parts share is compressed twice.
Hdf5File::TableLayout point_layout(const Frame& frame, int n_columns)
{
  Hdf5File::TableLayout layout = point_layout(frame.n_whole(), n_columns);
  if (!frame.ends()) layout.chunk_rows = std::min(layout.chunk_rows, (frame.n_points() + 3) / 4);
  return layout;
}

/// A table of n rows; row(k) is row k.
template <class T, class F>
void add_table(Hdf5File& file, const std::string& name, std::int64_t n, F&& row)
{
  const Hdf5File::TableLayout layout = point_layout(n, 0);
  file.create_table<T>(name, layout);
  std::vector<T> rows;
  for (std::int64_t first = 0; first < n; first += layout.chunk_rows) {
    rows.resize(static_cast<std::size_t>(std::min(layout.chunk_rows, n - first)));
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = row(first + static_cast<std::int64_t>(k));
    file.write_rows<T>(name, first, rows);
  }
}

void add_topology(Hdf5File& file, std::int64_t n)
{
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
    file.write<std::int64_t>(root + "/" + name, {1}, std::vector<std::int64_t>{n});
  }
  const auto counting = [](std::int64_t k) { return k; };
  add_table<std::int64_t>(file, root + "/Offsets", n + 1, counting);
  add_table<std::int64_t>(file, root + "/Connectivity", n, counting);
  add_table<std::uint8_t>(file, root + "/Types", n, [](std::int64_t) { return vtk_vertex; });
  add_table<std::int64_t>(file, point_data + "/id", n, counting);
  file.set_text(point_data + "/id", "unit", "-");
}

void add_field(Hdf5File& file, const PointField& field, const Frame& frame)
{
  const std::string name = point_data + "/" + field.name;
  file.create_table<Real>(name, point_layout(frame, n_columns(field.n_components)));
  describe_field(file, name, field.unit, field.n_components);
  file.create_table<std::int64_t>(point_data_offsets + "/" + field.name, {});
}

/// A file with no frame yet.
void write_empty(const std::string& path, const std::string& run, const Frame& frame)
{
  Hdf5File file(path, Hdf5File::Mode::create, largest_size(frame, frame.n_whole()));
  for (const auto& group : {root, steps, point_data, point_data_offsets}) file.create_group(group);
  add_header(file, run);
  add_steps(file);
  file.create_table<std::int64_t>(point_data_offsets + "/id", {});
  add_topology(file, frame.n_whole());
  file.create_table<Real>(root + "/Points", point_layout(frame, 3));
  file.set_text(root + "/Points", "unit", "m");
  for (const auto& field : frame.fields) add_field(file, field, frame);
  file.close();
}

void create(const std::string& path, const std::string& run, const Frame& frame)
{
  write_whole(path, [&](const std::string& temporary) { write_empty(temporary, run, frame); });
}

/// Throws if the file was made for other points or fields than those of the frame.
void check_fit(const Hdf5File& file, const std::string& path, const Frame& frame)
{
  const auto refuse = [&](const std::string& why) {
    throw FileError(fmt::format("cannot add the frame of step {} to {}: {}", frame.step, path, why));
  };
  const std::int64_t n = file.read_rows<std::int64_t>(root + "/NumberOfPoints", 0, 1)[0];
  if (n != frame.n_whole()) refuse(fmt::format("the file has {} points, the run {}", n, frame.n_whole()));
  for (const auto& field : frame.fields) {
    const std::string name = point_data + "/" + field.name;
    if (!file.exists(name)) refuse("the file has no field " + field.name);
    const auto shape = file.shape(name);
    const bool same = (shape.size() == 1 ? 0 : shape[1]) == n_columns(field.n_components);
    if (!same || std::ssize(field.values) != frame.n_points() * field.n_components)
      refuse("field " + field.name + " has another size");
  }
  const std::size_t n_fields = file.members(point_data).size() - 1;  // besides id
  if (n_fields != frame.fields.size())
    refuse(fmt::format("the file has {} fields, the run {}", n_fields, frame.fields.size()));
}

void write_offsets(Hdf5File& file, const Frame& frame, std::int64_t k)
{
  const std::int64_t first_row = k * frame.n_whole();
  write_step(file, k, frame.time, frame.step, first_row);
  write_integer(file, point_data_offsets + "/id", k, 0);
  for (const auto& field : frame.fields) write_integer(file, point_data_offsets + "/" + field.name, k, first_row);
}

void write_points(Hdf5File& file, const Frame& frame, std::int64_t k)
{
  const std::int64_t first_row = k * frame.n_whole() + frame.first;
  file.write_rows<Real>(root + "/Points", first_row, with_z(frame.x));
  for (const auto& field : frame.fields) {
    const std::string name = point_data + "/" + field.name;
    if (field.n_components == 2)
      file.write_rows<Real>(name, first_row, with_z(field.values));
    else
      file.write_rows<Real>(name, first_row, field.values);
  }
}

}  // namespace

void ResultsFile::append(const Frame& frame)
{
  std::unique_ptr<Hdf5File> file = std::move(open_);  // dropped with all changes if a part cannot be written
  if (frame.first == 0) {
    if (!std::filesystem::exists(path_)) create(path_, run_, frame);
    file = std::make_unique<Hdf5File>(path_, Hdf5File::Mode::commit, largest_size(frame, frame.n_whole()));
  }
  check_fit(*file, path_, frame);
  const std::int64_t k = file->integer(steps, "NSteps");
  write_points(*file, frame, k);
  if (!frame.ends()) {
    open_ = std::move(file);
    return;
  }
  write_offsets(*file, frame, k);
  file->set_integers(steps, "NSteps", {k + 1});
  file->close();
}

std::int64_t ResultsFile::count_until(std::int64_t step) const
{
  finish_commit(path_);
  return std::filesystem::exists(path_) ? count_steps(Hdf5File(path_, Hdf5File::Mode::read), step) : 0;
}

std::unique_ptr<Hdf5File> ResultsFile::open_to_cut() const
{
  return std::filesystem::exists(path_) ? std::make_unique<Hdf5File>(path_, Hdf5File::Mode::commit, cutting_bytes)
                                        : nullptr;
}

void ResultsFile::cut_after(Hdf5File& file, std::int64_t step, const std::vector<PointField>& fields)
{
  const std::int64_t n = file.read_rows<std::int64_t>(root + "/NumberOfPoints", 0, 1)[0];
  file.shape(point_data + "/id");  // must be there
  std::vector<StepTable> tables{{root + "/Points", n, 3}};
  for (const auto& field : fields) tables.push_back({point_data + "/" + field.name, n, n_columns(field.n_components)});
  cut_steps(file, step, tables);
}

}  // namespace terp
