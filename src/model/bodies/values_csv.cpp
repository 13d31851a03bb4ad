// Places form a grid only if there are as many of them as distinct x times distinct y. This count suffices because
// no place occurs twice, which the reader makes sure of. One line of places, as a boring has, is put twice. Coordinates
// are compared without a tolerance, as a file writes a line of a grid with the same digits. Beyond a grid, the value at
// its edge holds.

#include "model/bodies/values_csv.hpp"

#include "os/read_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <utility>

namespace terp {
namespace {

const std::array<std::string, 3> columns_of_values{"x", "y", "value"};
const std::string table_of_values = "the table of values";

std::vector<Real> distinct(const std::vector<PlacedValue>& values, int axis)
{
  std::vector<Real> all;
  for (const PlacedValue& value : values) all.push_back(value.x[axis]);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Interval of a line of the grid that holds x, and the share of the way through it; the ends stay the ends.
std::pair<std::size_t, Real> interval_of(const std::vector<Real>& line, Real x)
{
  const Real inside = std::clamp(x, line.front(), line.back());
  const auto after = std::upper_bound(line.begin() + 1, line.end() - 1, inside);
  const auto k = static_cast<std::size_t>(after - line.begin()) - 1;
  return {k, (inside - line[k]) / (line[k + 1] - line[k])};
}

std::size_t number_in(const std::vector<Real>& line, Real x)
{
  return static_cast<std::size_t>(std::ranges::lower_bound(line, x) - line.begin());
}

}  // namespace

ValueMap::ValueMap(std::vector<PlacedValue> values) : values_(std::move(values))
{
  std::vector<Real> x = distinct(values_, 0), y = distinct(values_, 1);
  low_ = {x.front(), y.front()};
  high_ = {x.back(), y.back()};
  if (x.size() * y.size() == 1) return;
  if (x.size() > 1 && y.size() > 1)
    share_of_grid_ = static_cast<Real>(values_.size()) / static_cast<Real>(x.size() * y.size());
  if (x.size() * y.size() != values_.size()) return;
  for (const auto& [line, axis] : {std::pair(&x, 0), std::pair(&y, 1)}) {
    if (line->size() > 1) continue;  // else the values hold along the whole axis
    low_[axis] = -std::numeric_limits<Real>::infinity(), high_[axis] = -low_[axis];
    const std::size_t n = values_.size();
    for (std::size_t k = 0; k < n; ++k) values_.push_back(values_[k]), values_.back().x[axis] += 1.0;
    line->push_back(line->front() + 1.0);
  }
  x_ = std::move(x);
  y_ = std::move(y);
  at_grid_.resize(values_.size());
  for (const PlacedValue& v : values_) at_grid_[number_in(y_, v.x[1]) * x_.size() + number_in(x_, v.x[0])] = v.value;
}

bool lies_far_off(Real value, std::initializer_list<Real> others)
{
  constexpr Real far = 8.0;
  const auto [low, high] = std::ranges::minmax(others);
  return low > 0.0 && value > 0.0 && (value >= far * high || far * value <= low);
}

std::optional<PlacedValue> ValueMap::find_far_off() const
{
  const std::size_t n = x_.size();
  const auto is_odd = [&](std::size_t k, std::size_t stride) {
    return lies_far_off(at_grid_[k], {at_grid_[k - stride], at_grid_[k + stride]});
  };
  for (std::size_t k = 0; k < at_grid_.size(); ++k) {
    const std::size_t i = k % n, j = k / n;
    const bool in_row = i > 0 && i + 1 < n, in_column = j > 0 && j + 1 < y_.size();
    if ((!in_row && !in_column) || (in_row && !is_odd(k, 1)) || (in_column && !is_odd(k, n))) continue;
    return PlacedValue{{x_[i], y_[j]}, at_grid_[k]};
  }
  return std::nullopt;
}

Real ValueMap::at(Vec<2> x) const { return is_grid() ? on_grid(x) : by_distance(x); }

Real ValueMap::on_grid(Vec<2> x) const
{
  const auto [i, s] = interval_of(x_, x[0]);
  const auto [j, t] = interval_of(y_, x[1]);
  const Real* const row = &at_grid_[j * x_.size() + i];
  const Real* const next = row + x_.size();
  return std::lerp(std::lerp(row[0], row[1], s), std::lerp(next[0], next[1], s), t);
}

Real ValueMap::by_distance(Vec<2> x) const
{
  std::vector<std::pair<Real, Real>> nearest;  // square of the distance, value
  nearest.reserve(values_.size());
  for (const PlacedValue& v : values_) {
    const Real dx = v.x[0] - x[0], dy = v.x[1] - x[1], square = dx * dx + dy * dy;
    if (square == 0.0) return v.value;
    nearest.emplace_back(square, v.value);
  }
  const auto end = nearest.begin() + static_cast<std::ptrdiff_t>(std::min(n_nearest, nearest.size()));
  std::ranges::partial_sort(nearest, end);
  Real sum = 0.0, weights = 0.0;
  for (auto at = nearest.begin(); at != end; ++at) sum += at->second / at->first, weights += 1.0 / at->first;
  return sum / weights;
}

ValueMap read_values_csv_text(const std::string& path, const std::string& text)
{
  std::vector<PlacedValue> values;
  std::map<Vec<2>, Index> lines;
  CsvFaults faults(path, table_of_values, "It has the columns x, y, value: m, m, and the unit of the key in SI.");
  read_csv_rows(text, columns_of_values, faults, [&](std::span<const std::string> cells, Index line) {
    std::array<Real, 3> row{};
    for (std::size_t k = 0; k < row.size(); ++k)
      row[k] = finite_number_in_csv(cells[k], columns_of_values[k], line, faults);
    const auto [first, is_new] = lines.emplace(Vec<2>{row[0], row[1]}, line);
    if (!is_new) faults.add(line, fmt::format("the place ({}, {}) m is in line {} too", row[0], row[1], first->second));
    values.push_back({{row[0], row[1]}, row[2]});
  });
  ValueMap map(std::move(values));
  if (!map.is_grid() && lines.size() > ValueMap::most_scattered)
    throw CsvError(
        fmt::format("{} {} has {} places that form no grid; at most {}. Give them on a grid: each x "
                    "with each y.",
            table_of_values, path, lines.size(), ValueMap::most_scattered));
  return map;
}

ValueMap read_values_csv(const std::string& path) { return read_values_csv_text(path, read_file(path)); }

}  // namespace terp
