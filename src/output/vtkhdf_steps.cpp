#include "output/vtkhdf_steps.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace terp::vtkhdf {
namespace {

std::string component_names(int n_columns)
{
  switch (n_columns) {
    case 3:
      return "x y z";
    case 4:
      return "xx yy zz xy";
    case 6:
      return "xx yy zz xy yz zx";
    default:
      return "";
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

std::string why_of_another_run(const Hdf5File& file, const std::string& run, std::int64_t n_cells)
{
  const std::int64_t n = file.read_rows<std::int64_t>(root + "/NumberOfCells", 0, 1)[0];
  if (n != n_cells) return fmt::format("it has {} cells, the run {}", n, n_cells);
  const std::string other = file.has_attribute("/", "case") ? file.text("/", "case") : run;
  return run.empty() || other == run ? "" : fmt::format("it is of a run of another case (`case` in it is {}, of this run {})", other, run);
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
  for (const char* name : {"PartOffsets", "CellOffsets", "ConnectivityIdOffsets"}) write_integer(file, steps + "/" + name, k, 0);
  write_integer(file, steps + "/PointOffsets", k, first_point);
}

std::int64_t count_steps(const Hdf5File& file, std::int64_t step)
{
  const auto step_numbers = file.read<std::int64_t>(steps + "/step");
  const std::int64_t n_whole = std::clamp<std::int64_t>(file.integer(steps, "NSteps"), 0, std::ssize(step_numbers));
  return std::upper_bound(step_numbers.begin(), step_numbers.begin() + n_whole, step) - step_numbers.begin();
}

void cut_steps(Hdf5File& file, std::int64_t step, const std::vector<StepTable>& tables)
{
  const std::int64_t n_steps = count_steps(file, step);
  file.set_integers(steps, "NSteps", {n_steps});
  for (const auto& table : tables) file.cut_rows(table.name, n_steps * table.n_rows);
  for (const auto& name : file.members(steps)) {
    const std::string member = steps + "/" + name;
    if (!name.ends_with("DataOffsets"))
      file.cut_rows(member, n_steps);
    else
      for (const auto& field : file.members(member)) file.cut_rows(member + "/" + field, n_steps);
  }
}

}  // namespace terp::vtkhdf
