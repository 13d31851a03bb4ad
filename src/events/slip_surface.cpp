#include "events/slip_surface.hpp"

#include "mesh/shape_functions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;

constexpr Real share_of_column = 0.5;  // of the fastest growth in a column: the lower edge of a shear band
constexpr Real share_of_all = 0.1;     // of the fastest growth: columns that shear at all
constexpr Real fast = 0.999;           // part of the points that grow more slowly than "the fastest"

float growth_of(const PointBlock<2>& block, Index lane, std::span<const float> growth)
{
  return growth[static_cast<std::size_t>(block.row(Rows::id)[lane])];
}

/// N_i at a point.
std::array<Real, 4> shares_of(const PointBlock<2>& block, Index lane)
{
  return shape_functions(block.row(Rows::xi)[lane], block.row(Rows::xi + 1)[lane]);
}

/// The column of a place; -1 outside all.
Index column_of(Real x, const Columns& columns)
{
  const Real place = (x - columns.left) / columns.width;
  return place >= 0.0 && place < columns.n ? static_cast<Index>(place) : -1;
}

Real fastest_growth(const PointBlocks<2>& points, std::span<const float> growth)
{
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(points.n_points()));
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) { values.push_back(growth_of(block, lane, growth)); });
  if (values.empty()) return 0.0;
  const auto quantile = values.begin() + static_cast<std::ptrdiff_t>(fast * static_cast<Real>(values.size() - 1));
  std::nth_element(values.begin(), quantile, values.end());
  return *quantile;
}

}  // namespace

Real total_growth(const PointBlocks<2>& points, std::span<const float> growth, const Columns& columns)
{
  Real sum = 0.0;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    if (column_of(block.row(Rows::x)[lane], columns) >= 0) sum += block.row(Rows::volume)[lane] * growth_of(block, lane, growth);
  });
  return sum;
}

std::vector<float> mean_over_nodes(const Mesh<2>& mesh, const PointBlocks<2>& points, std::span<const float> values)
{
  std::vector<Real> sum(static_cast<std::size_t>(mesh.n_nodes())), weight(sum.size());
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const auto N = shares_of(block, lane);
    for (int i = 0; i < 4; ++i) {
      const Index node = mesh.cells[block.cell][i];
      weight[node] += N[i] * block.row(Rows::volume)[lane];
      sum[node] += N[i] * block.row(Rows::volume)[lane] * growth_of(block, lane, values);
    }
  });
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = weight[i] > 0.0 ? sum[i] / weight[i] : 0.0;
  std::vector<float> smooth(values.size());
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const auto N = shares_of(block, lane);
    Real value = 0.0;
    for (int i = 0; i < 4; ++i) value += N[i] * sum[mesh.cells[block.cell][i]];
    smooth[static_cast<std::size_t>(block.row(Rows::id)[lane])] = static_cast<float>(value);
  });
  return smooth;
}

std::vector<Vec<2>> find_slip_line(const PointBlocks<2>& points, std::span<const float> growth, const Columns& columns)
{
  const Real least = share_of_all * fastest_growth(points, growth);
  std::vector<Real> most(static_cast<std::size_t>(columns.n), 0.0);
  const auto visit = [&](auto&& f) {
    for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
      const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
      if (const Index c = column_of(x[0], columns); c >= 0) f(static_cast<std::size_t>(c), x, growth_of(block, lane, growth));
    });
  };
  visit([&](std::size_t c, Vec<2>, Real g) { most[c] = std::max(most[c], g); });
  std::vector<Vec<2>> lowest(most.size(), Vec<2>{0.0, std::numeric_limits<Real>::infinity()});
  visit([&](std::size_t c, Vec<2> x, Real g) {
    if (g >= share_of_column * most[c] && x[1] < lowest[c][1]) lowest[c] = x;
  });
  std::vector<Vec<2>> line;
  for (std::size_t c = 0; c < most.size(); ++c)
    if (most[c] > 0.0 && most[c] >= least) line.push_back(lowest[c]);
  return line;
}

}  // namespace terp
