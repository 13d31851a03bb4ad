// A static VTKHDF file, version 1.0, type UnstructuredGrid, one vertex cell per point. Places are exact (float64),
// fields have single precision unless asked otherwise: the state in full is the checkpoint's.
#include "io/files/point_frames.hpp"

#include "io/files/hdf5_file.hpp"

#include <algorithm>

namespace terp {
namespace {

using namespace vtkhdf;

constexpr std::uint8_t vtk_vertex = 1;  // VTK_VERTEX of vtkCellType.h

/// At least what a frame takes in its file, should it not compress at all.
std::int64_t largest_size(const Frame& frame, std::int64_t bytes_per_number)
{
  const std::int64_t n = frame.n_whole(), n_datasets = 10 + std::ssize(frame.fields);
  std::int64_t n_bytes = n * (3 * 8 + 4 + 4 + 1) + n_datasets * hdf5_header_bytes;
  for (const auto& field : frame.fields) n_bytes += n * std::max(3, field.n_components) * bytes_per_number;
  return n_bytes;
}

void write_cells(Hdf5File& file, std::int64_t n)
{
  const auto counting = [](std::size_t k, auto& values) { values.push_back(static_cast<std::int64_t>(k)); };
  write_sizes(file, n, n, n);
  write_rows<std::int64_t>(file, root + "/Offsets", {n + 1}, whole, counting);
  write_rows<std::int64_t>(file, root + "/Connectivity", {n}, whole, counting);
  write_rows<std::uint8_t>(
      file, root + "/Types", {n}, exact, [](std::size_t, auto& types) { types.push_back(vtk_vertex); });
}

/// Numbers of materials and cells are whole; above 16 million they have no equal of single precision.
Hdf5File::Layout layout_of(const PointField& field, bool exact_fields)
{
  return field.name == "material" || field.name == "cell" ? whole : exact_fields ? exact : single;
}

}  // namespace

void PointFrameWriter::append(const Frame& frame)
{
  const std::int64_t n = frame.n_whole();
  if (frame.first == 0)
    write_cells(series_.begin(frame.time, frame.step, largest_size(frame, exact_fields_ ? 8 : 4)), n);
  Hdf5File& file = series_.open();
  write_field(file, {root + "/Points", "m", 2, n, frame.first}, frame.x, exact);
  for (const PointField& field : frame.fields)
    write_field(file, {root + "/PointData/" + field.name, field.unit, field.n_components, n, frame.first}, field.values,
        layout_of(field, exact_fields_));
  if (frame.ends()) series_.end();
}

}  // namespace terp
