#include "model/bodies/points_csv.hpp"

#include "os/read_file.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

const std::array<std::string, 4> columns_of_points{"x", "y", "volume", "material"};

/// The point of one line; faults are noted, and the point is then of no use.
CsvPoint read_row(std::span<const std::string> cells, Index line, CsvFaults& faults)
{
  CsvPoint point{{0.0, 0.0}, 0.0, std::string(cells[3]), line};
  const std::array<Real*, 3> numbers{&point.x[0], &point.x[1], &point.volume};
  for (std::size_t k = 0; k < numbers.size(); ++k)
    *numbers[k] = finite_number_in_csv(cells[k], columns_of_points[k], line, faults);
  if (const auto volume = number_in_csv(cells[2]); volume && std::isfinite(*volume) && *volume <= 0.0)
    faults.add(line, fmt::format("volume is {} m^2; it must be greater than 0", cells[2]));
  if (point.material.empty()) faults.add(line, "material is empty");
  return point;
}

}  // namespace

std::vector<CsvPoint> read_points_csv_text(const std::string& path, const std::string& text)
{
  std::vector<CsvPoint> points;
  CsvFaults faults(path, "the table of points",
      "It has the columns x, y, volume, material: m, m, m^2 (volume per metre of thickness), and a material of the "
      "case.");
  read_csv_rows(text, columns_of_points, faults,
      [&](std::span<const std::string> cells, Index line) { points.push_back(read_row(cells, line, faults)); });
  return points;
}

std::vector<CsvPoint> read_points_csv(const std::string& path) { return read_points_csv_text(path, read_file(path)); }

}  // namespace terp
