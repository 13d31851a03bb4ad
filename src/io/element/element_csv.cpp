#include "io/element/element_csv.hpp"

#include "math/utf8.hpp"
#include "model/bodies/csv_rows.hpp"
#include "os/csv.hpp"
#include "os/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <optional>

namespace terp {
namespace {

constexpr int usual_increments = 1000;  // of a whole path
const std::vector<std::string> path_columns{
    "time", "strain_xx", "strain_yy", "strain_zz", "strain_xy", "stress_xx", "stress_yy", "stress_zz", "stress_xy"};

/// Those of the columns that a table has, and what else its first line names, which is refused with them.
std::vector<std::string> columns_of(const std::string& text)
{
  std::vector<std::string> columns;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = trimmed(std::string_view(text).substr(at, end - at));
    at = end + 1;
    if (line.empty() || line.front() == '#') continue;
    const auto cells = csv_cells(line);
    for (const std::string& known : path_columns)
      if (std::ranges::any_of(cells, [&](const std::string& cell) { return trimmed(cell) == known; }))
        columns.push_back(known);
    break;
  }
  return columns.empty() ? path_columns : columns;
}

using Cells = std::span<const std::string>;

/// A row of the table by the numbers of path_columns.
class PathRow {
 public:
  PathRow(const std::vector<std::string>& columns, Cells cells, Index line, CsvFaults& faults)
  {
    values_.resize(path_columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (!cells[k].empty())
        values_[static_cast<std::size_t>(std::ranges::find(path_columns, columns[k]) - path_columns.begin())] =
            finite_number_in_csv(cells[k], columns[k], line, faults);
  }
  std::optional<Real> time() const { return values_[0]; }
  std::optional<Real> strain(int k) const { return values_[static_cast<std::size_t>(1 + k)]; }
  std::optional<Real> stress(int k) const { return values_[static_cast<std::size_t>(5 + k)]; }

 private:
  std::vector<std::optional<Real>> values_;
};

}  // namespace

ElementPath read_path_csv_text(const std::string& path, const std::string& text, const PathFileOptions& options)
{
  const std::vector<std::string> columns = columns_of(text);
  CsvFaults faults(path, "the path",
      "It has some of the columns time, strain_xx, strain_yy, strain_zz, strain_xy [-], "
      "stress_xx, stress_yy, stress_zz, stress_xy [Pa]; tension is positive.");
  ElementPath found{.stress = options.stress, .undrained = options.undrained};
  Real time = 0.0;
  read_csv_rows(text, columns, faults, [&](Cells cells, Index line) {
    const PathRow row(columns, cells, line, faults);
    ElementLeg leg;
    for (int k = 0; k < 4; ++k) {
      if (row.strain(k) && row.stress(k))
        faults.add(line, fmt::format("strain and stress {} are both given; leave one of them empty",
                             path_columns[static_cast<std::size_t>(1 + k)].substr(7)));
      leg.control[k] = row.stress(k) ? Control::stress : Control::strain;
      leg.target[k] = row.stress(k) ? *row.stress(k) : row.strain(k).value_or(std::numeric_limits<Real>::quiet_NaN());
    }
    leg.duration = std::nan("");
    if (row.time()) {
      if (!(*row.time() > time)) faults.add(line, fmt::format("the time {} does not come after {}", *row.time(), time));
      leg.duration = *row.time() - time, time = *row.time();
    }
    found.legs.push_back(leg);
  });
  faults.stop_if_any();
  const auto n = static_cast<int>(found.legs.size());
  for (ElementLeg& leg : found.legs) {
    leg.increments = options.increments > 0 ? options.increments : (usual_increments + n - 1) / n;
    if (std::isnan(leg.duration)) leg.duration = options.duration / n;
  }
  return found;
}

ElementPath read_path_csv(const std::string& path, const PathFileOptions& options)
{
  return read_path_csv_text(path, read_file(path), options);
}

std::string element_csv(const ElementResult& result)
{
  std::string text;
  for (const ElementColumn& column : result.columns) text += (text.empty() ? "" : ",") + column.name;
  for (std::size_t row = 0; row < result.columns.front().values.size(); ++row) {
    text += '\n';
    for (const ElementColumn& column : result.columns) {
      if (&column != &result.columns.front()) text += ',';
      const Real value = column.values[row];
      if (std::isnan(value))
        text += "nan";
      else
        fmt::format_to(std::back_inserter(text), "{}", value);
    }
  }
  return text + '\n';
}

}  // namespace terp
