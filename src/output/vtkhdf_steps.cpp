#include "output/vtkhdf_steps.hpp"

#include "base/errors.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp::vtkhdf {
namespace {

std::string component_names(int n_columns)
{
  switch (n_columns) {
    case 3: return "x y z";
    case 4: return "xx yy zz xy";
    case 6: return "xx yy zz xy yz zx";
    default: return "";
  }
}

}  // namespace

int n_columns(int n_components) { return n_components == 1 ? 0 : std::max(3, n_components); }

std::vector<Real> with_z(const std::vector<Real>& values)
{
  std::vector<Real> rows(values.size() / 2 * 3, 0.0);
  for (std::size_t k = 0; k < values.size() / 2; ++k) {
    rows[3 * k] = values[2 * k];
    rows[3 * k + 1] = values[2 * k + 1];
  }
  return rows;
}

void add_header(Hdf5File& file, const std::string& run)
{
  file.set_integers(root, "Version", {2, 0});
  file.set_text(root, "Type", "UnstructuredGrid");
  file.set_text("/", "terp_version", TERP_VERSION);
  if (!run.empty()) file.set_text("/", "case", run);
}

std::string why_of_another_run(const Hdf5File& file, const std::string& run, const GridSize& grid)
{
  const auto number = [&](const char* name) { return file.read_rows<std::int64_t>(root + "/" + name, 0, 1)[0]; };
  if (const std::int64_t n = number("NumberOfCells"); n != grid.n_cells)
    return fmt::format("it has {} cells, the run {}", n, grid.n_cells);
  if (const std::int64_t n = number("NumberOfPoints"); n != grid.n_points)
    return fmt::format("it has {} points, the run {}", n, grid.n_points);
  const std::string other = file.has_attribute("/", "case") ? file.text("/", "case") : run;
  return run.empty() || other == run
             ? ""
             : fmt::format("it is of a run of another case (`case` in it is {}, of this run {})", other, run);
}

void add_steps(Hdf5File& file)
{
  file.set_integers(steps, "NSteps", {0});
  file.create_table<Real>(steps + "/Values", {});
  file.set_text(steps + "/Values", "unit", "s");
  for (const char* name : {"step", "PartOffsets", "NumberOfParts", "PointOffsets"}) {
    file.create_table<std::int64_t>(steps + "/" + name, {});
  }
  for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) {
    file.create_table<std::int64_t>(steps + "/" + name, {.n_columns = 1});
  }
}

void describe_field(Hdf5File& file, const std::string& table, const std::string& unit, int n_components)
{
  file.set_text(table, "unit", unit);
  const std::string names = component_names(n_columns(n_components));
  if (!names.empty()) file.set_text(table, "components", names);
}

void write_integer(Hdf5File& file, const std::string& table, std::int64_t row, std::int64_t value)
{
  file.write_rows<std::int64_t>(table, row, std::span(&value, 1));
}

void write_step(Hdf5File& file, std::int64_t k, Real time, std::int64_t step, std::int64_t first_point)
{
  file.write_rows<Real>(steps + "/Values", k, std::span(&time, 1));
  write_integer(file, steps + "/step", k, step);
  write_integer(file, steps + "/NumberOfParts", k, 1);
  for (const char* name : {"PartOffsets", "CellOffsets", "ConnectivityIdOffsets"})
    write_integer(file, steps + "/" + name, k, 0);
  write_integer(file, steps + "/PointOffsets", k, first_point);
}

namespace {

/// The tables of the steps themselves.
std::vector<StepTable> tables_of_steps(const Hdf5File& file)
{
  std::vector<StepTable> tables;
  for (const char* name : {"Values", "step", "PartOffsets", "NumberOfParts", "PointOffsets"})
    tables.push_back({steps + "/" + name, 1, 0});
  for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) tables.push_back({steps + "/" + name, 1, 1});
  for (const auto& data : {std::string("PointData"), std::string("CellData")}) {
    const std::string offsets = steps + "/" + data + "Offsets";
    if (!file.exists(offsets)) continue;
    for (const auto& field : file.members(root + "/" + data)) tables.push_back({offsets + "/" + field, 1, 0});
  }
  return tables;
}

void check_table(const Hdf5File& file, const StepTable& table, std::int64_t n_steps)
{
  const auto shape = file.shape(table.name);
  const std::int64_t n_columns = shape.size() == 2 ? shape[1] : 0;
  if (shape.empty() || shape.size() > 2 || n_columns != table.n_columns ||
      shape[0] / std::max<std::int64_t>(1, table.n_rows) < n_steps)
    throw FileError(
        fmt::format("{} has the shape {}; {} steps of {} rows{} are due", table.name, fmt::join(shape, " x "), n_steps,
            table.n_rows, table.n_columns > 0 ? fmt::format(" x {}", table.n_columns) : ""));
}

}  // namespace

std::int64_t count_steps(const Hdf5File& file, std::int64_t step)
{
  const auto step_numbers = file.read<std::int64_t>(steps + "/step");
  const std::int64_t n_whole = std::clamp<std::int64_t>(file.integer(steps, "NSteps"), 0, std::ssize(step_numbers));
  return std::upper_bound(step_numbers.begin(), step_numbers.begin() + n_whole, step) - step_numbers.begin();
}

void cut_steps(Hdf5File& file, std::int64_t step, std::vector<StepTable> tables)
{
  const auto of_steps = tables_of_steps(file);
  tables.insert(tables.end(), of_steps.begin(), of_steps.end());
  const std::int64_t n_whole = file.integer(steps, "NSteps");
  for (const StepTable& table : tables) check_table(file, table, n_whole);
  const std::int64_t n_steps = count_steps(file, step);
  for (const StepTable& table : tables)  // the piece that the next step may share, which HDF5 would read then
    if (const std::int64_t n = n_steps * table.n_rows; n > 0) file.read_rows<Real>(table.name, n - 1, 1);
  file.set_integers(steps, "NSteps", {n_steps});
  for (const StepTable& table : tables) file.cut_rows(table.name, n_steps * table.n_rows);
}

}  // namespace terp::vtkhdf
