// Points are visited twice: first for the fastest growth in each column, then for the lowest point that has half of it.
// That point is the lower edge of the shear band. "Fastest" of all points is a quantile, so that single points do not
// decide which columns count.

#include "run/measure/slip_surface.hpp"

#include "mpm/mesh/quad4.hpp"

#include <algorithm>
#include <limits>

namespace terp {
namespace {

constexpr Real share_of_column = 0.5;  // of the fastest growth in a column: the lower edge of a shear band
constexpr Real share_of_all = 0.1;     // of the fastest growth: columns that shear at all
constexpr Real fast = 0.999;           // part of the points that grow more slowly than "the fastest"

/// N_i at a point.
std::array<Real, 4> shares_of(const PointBlock<2>& block, Index lane)
{
  return Quad4::shape_functions(Vec<2>{block.row(Rows::xi)[lane], block.row(Rows::xi + 1)[lane]});
}

/// The column of a place; -1 outside all.
Index column_of(Real x, const Columns& columns)
{
  const Real place = (x - columns.left) / columns.width;
  return place >= 0.0 && place < columns.n ? static_cast<Index>(place) : -1;
}

/// What all but 0.1 % of the values stay below; 0 without any.
Real fastest_of(std::span<const float> growth)
{
  if (growth.empty()) return 0.0;
  std::vector<float> values(growth.begin(), growth.end());
  const auto quantile = values.begin() + static_cast<std::ptrdiff_t>(fast * static_cast<Real>(values.size() - 1));
  std::nth_element(values.begin(), quantile, values.end());
  return *quantile;
}

}  // namespace

std::vector<float> mean_over_nodes(const Mesh<2>& mesh, const PointBlocks<2>& points, std::span<const float> values)
{
  std::vector<Real> sum(static_cast<std::size_t>(mesh.n_nodes())), weight(sum.size());
  std::size_t k = 0;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const auto N = shares_of(block, lane);
    const Real value = values[k++], volume = block.row(Rows::volume)[lane];
    for (int i = 0; i < 4; ++i) {
      const Index node = mesh.cells[block.cell][i];
      weight[node] += N[i] * volume;
      sum[node] += N[i] * volume * value;
    }
  });
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = weight[i] > 0.0 ? sum[i] / weight[i] : 0.0;
  std::vector<float> smooth;
  smooth.reserve(values.size());
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const auto N = shares_of(block, lane);
    Real value = 0.0;
    for (int i = 0; i < 4; ++i) value += N[i] * sum[mesh.cells[block.cell][i]];
    smooth.push_back(static_cast<float>(value));
  });
  return smooth;
}

std::vector<Vec<2>> find_slip_line(const PointBlocks<2>& points, std::span<const float> growth, const Columns& columns)
{
  const Real least = share_of_all * fastest_of(growth);
  std::vector<Real> most(static_cast<std::size_t>(columns.n), 0.0);
  const auto visit =
      [&](auto&& f) {  // those that may matter: a column counts from `least` on, and in it half of its most
        std::size_t k = 0;
        for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
          const Real g = growth[k++];
          if (!(g >= share_of_column * least && g > 0.0)) return;
          const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
          if (const Index c = column_of(x[0], columns); c >= 0) f(static_cast<std::size_t>(c), x, g);
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

std::vector<Vec<2>> part_below_motion(
    const std::vector<Vec<2>>& line, const PointBlocks<2>& points, Ground ground, const Columns& columns, Facing facing)
{
  constexpr Real nowhere = std::numeric_limits<Real>::infinity();
  std::vector<Real> bottom(static_cast<std::size_t>(columns.n), nowhere), momentum(bottom.size(), 0.0);
  for (const Vec<2>& x : line)
    if (const Index c = column_of(x[0], columns); c >= 0) bottom[static_cast<std::size_t>(c)] = x[1];
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const Index c = column_of(block.row(Rows::x)[lane], columns);
    if (c < 0 || !is_ground(ground, block) || block.row(Rows::x + 1)[lane] < bottom[static_cast<std::size_t>(c)])
      return;
    momentum[static_cast<std::size_t>(c)] += block.row(Rows::mass)[lane] * block.row(Rows::v)[lane];
  });
  std::vector<Vec<2>> part, longest;
  for (const Vec<2>& x : line) {
    const Index c = column_of(x[0], columns);
    if (c >= 0 && outwards(facing) * momentum[static_cast<std::size_t>(c)] > 0.0)
      part.push_back(x);
    else
      part.clear();
    if (part.size() > longest.size()) longest = part;
  }
  return longest;
}

}  // namespace terp
