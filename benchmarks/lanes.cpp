// Lanes of a pack in the loops over points: eight points of one cell, as the program does it, or the k-th points of
// eight cells side by side. The second way needs no sums across lanes, but a group of cells takes as long as its
// fullest. The work per cell has one lane for each cell either way. A prototype of gather and strain of MPM-GP, on the
// column at rest and as it flows (decision 0031); cells of one shape, one material, the method's defaults. For packs of
// this machine: build with -DTERP_INSTRUCTIONS=native.

#include "ready.hpp"
#include "schemes/mpm_gp.hpp"

#include <cstdlib>

namespace terp {
namespace {

using Rows = PointRows<2>;
constexpr int rest = 200, flowing = 3000;  // steps

/// Eight neighbouring cells: number k of row r of lane c stands at data[(r * n + k) * pack_width + c]; beyond a cell's
/// points all is zero.
struct InterleavedCells {
  Index n = 0;  // points of the fullest cell
  std::array<Index, pack_width> slot{};
  std::vector<Pack> data;

  Pack& at(int row, Index k) { return data[static_cast<std::size_t>(row) * n + k]; }
  const Pack& at(int row, Index k) const { return data[static_cast<std::size_t>(row) * n + k]; }
};

void set_lane(Pack& pack, int lane, Real value)
{
  alignas(64) Real values[pack_width];
  pack.store(values);
  values[lane] = value;
  pack = Pack::load(values);
}

std::vector<InterleavedCells> make_groups(const PointBlocks<2>& points)
{
  std::vector<InterleavedCells> groups;
  const auto& cells = points.occupied();
  for (std::size_t first = 0; first + pack_width <= cells.size(); first += pack_width) {
    InterleavedCells& group = groups.emplace_back();
    const auto block_of = [&](int c) -> const PointBlock<2>& {
      return points.block(points.first_block(cells[first + c]));
    };
    for (int c = 0; c < pack_width; ++c) group.n = std::max(group.n, block_of(c).n);
    group.data.assign(static_cast<std::size_t>(points.n_rows()) * group.n, Pack(0.0));
    for (int c = 0; c < pack_width; ++c) {
      group.slot[c] = static_cast<Index>(first) + c;
      for (int r = 0; r < points.n_rows(); ++r)
        for (Index k = 0; k < block_of(c).n; ++k) set_lane(group.at(r, k), c, block_of(c).row(r)[k]);
    }
  }
  return groups;
}

using PerCorner = std::array<Pack, 4>;
constexpr auto zeros = [] { return PerCorner{Pack(0.0), Pack(0.0), Pack(0.0), Pack(0.0)}; };

struct GroupSums {
  PerCorner mass = zeros(), momentum_x = zeros(), momentum_y = zeros(), force_x = zeros(), force_y = zeros();
};

void map_group(const InterleavedCells& group, GroupSums& sums)
{
  for (Index k = 0; k < group.n; ++k) {
    const auto N = mapping_shares(group.at(Rows::xi, k), group.at(Rows::xi + 1, k));
    for (int i = 0; i < 4; ++i) {
      const Pack weight = N[i] * group.at(Rows::mass, k);
      sums.mass[i] += weight;
      sums.momentum_x[i] = fma(weight, group.at(Rows::v, k), sums.momentum_x[i]);
      sums.momentum_y[i] = fma(weight, group.at(Rows::v + 1, k), sums.momentum_y[i]);
    }
  }
}

/// Eqs. (1) to (4); returns p_e.
Pack gather_group(
    const CellGeometry<2>& cell, const MethodOptions& method, const InterleavedCells& group, GroupSums& sums)
{
  PerCorner volume = zeros();
  std::array<PerCorner, 4> sigma{zeros(), zeros(), zeros(), zeros()};
  const Pack zero(0.0);
  for (Index k = 0; k < group.n; ++k) {
    const Mask right = group.at(Rows::xi, k) >= Pack(-tie), upper = group.at(Rows::xi + 1, k) >= Pack(-tie);
    const Pack in_upper = select(upper, group.at(Rows::volume, k), zero),
               in_lower = select(upper, zero, group.at(Rows::volume, k));
    const PerCorner part{select(right, zero, in_lower), select(right, in_lower, zero), select(right, zero, in_upper),
        select(right, in_upper, zero)};
    for (int g = 0; g < 4; ++g) volume[g] += part[g];
    for (int r = 0; r < 4; ++r)
      for (int g = 0; g < 4; ++g) sigma[r][g] = fma(group.at(Rows::sigma + r, k), part[g], sigma[r][g]);
  }
  const Pack all = (volume[0] + volume[1]) + (volume[2] + volume[3]);
  const Mask filled = all / Pack(cell.volume) - Pack(method.filled_fraction) >= zero;
  PerCorner weight;
  for (int g = 0; g < 4; ++g) weight[g] = select(filled, Pack(cell.gauss_volume[g]), volume[g]);
  for (auto& component : sigma) {
    const Pack mean = ((component[0] + component[1]) + (component[2] + component[3])) / all;
    for (int g = 0; g < 4; ++g) component[g] = select(volume[g] > zero, component[g] / volume[g], mean);
  }
  PerCorner p;
  for (int g = 0; g < 4; ++g) p[g] = (sigma[0][g] + sigma[1][g] + sigma[2][g]) * Pack(1.0 / 3.0);
  const Pack pressure = ((p[0] * weight[0] + p[1] * weight[1]) + (p[2] * weight[2] + p[3] * weight[3])) /
                        ((weight[0] + weight[1]) + (weight[2] + weight[3]));
  Pack centre = zero;
  PerCorner xx, yy, xy;
  for (int g = 0; g < 4; ++g) {  // after Eq. (3) every Gauss point has the same pressure
    xx[g] = weight[g] * (sigma[0][g] - p[g]);
    yy[g] = weight[g] * (sigma[1][g] - p[g]);
    xy[g] = weight[g] * sigma[3][g];
    centre += weight[g] * pressure;
  }
  for (int i = 0; i < 4; ++i) {
    Pack fx = centre * Pack(cell.centre_gradient[i][0]), fy = centre * Pack(cell.centre_gradient[i][1]);
    for (int g = 0; g < 4; ++g) {
      fx = fma(xx[g], Pack(cell.gradient[i][0][g]), fma(xy[g], Pack(cell.gradient[i][1][g]), fx));
      fy = fma(yy[g], Pack(cell.gradient[i][1][g]), fma(xy[g], Pack(cell.gradient[i][0][g]), fy));
    }
    sums.force_x[i] = fx;
    sums.force_y[i] = fy;
  }
  return pressure;
}

void spread(const InterleavedCells& group, const GroupSums& sums, std::vector<CornerSums<2>>& corners)
{
  const PerCorner* from[] = {&sums.mass, &sums.momentum_x, &sums.momentum_y, &sums.force_x, &sums.force_y};
  for (int q = 0; q < 5; ++q)
    for (int i = 0; i < 4; ++i) {
      alignas(64) Real values[pack_width];
      (*from[q])[i].store(values);
      for (int c = 0; c < pack_width; ++c) {
        CornerSums<2>& to = corners[group.slot[c]];
        (q == 0 ? to.mass : q < 3 ? to.momentum[q - 1] : to.internal_force[q - 3])[i] = values[c];
      }
    }
}

/// Strain and volume of the points from displacements of the corners, shape [d][corner].
void strain_group(const CellGeometry<2>& cell, const std::array<PerCorner, 2>& du, InterleavedCells& group)
{
  std::array<PerCorner, 4> d_eps;
  Pack theta_0(0.0);
  for (int i = 0; i < 4; ++i)
    theta_0 += du[0][i] * Pack(cell.centre_gradient[i][0]) + du[1][i] * Pack(cell.centre_gradient[i][1]);
  for (int g = 0; g < 4; ++g) {
    Pack xx(0.0), yy(0.0), shear(0.0);
    for (int i = 0; i < 4; ++i) {
      const Pack gx(cell.gradient[i][0][g]), gy(cell.gradient[i][1][g]);
      xx = fma(du[0][i], gx, xx);
      yy = fma(du[1][i], gy, yy);
      shear = fma(du[0][i], gy, fma(du[1][i], gx, shear));
    }
    const Pack correction = (theta_0 - (xx + yy)) * Pack(1.0 / 3.0);
    d_eps[0][g] = xx + correction;
    d_eps[1][g] = yy + correction;
    d_eps[2][g] = correction;
    d_eps[3][g] = Pack(0.5) * shear;
  }
  for (Index k = 0; k < group.n; ++k) {
    const Mask right = group.at(Rows::xi, k) >= Pack(-tie), upper = group.at(Rows::xi + 1, k) >= Pack(-tie);
    Pack trace(0.0);
    for (int r = 0; r < 4; ++r) {
      const Pack d = select(upper, select(right, d_eps[r][3], d_eps[r][2]), select(right, d_eps[r][1], d_eps[r][0]));
      group.at(Rows::strain + r, k) += d;
      if (r < 3) trace += d;
    }
    group.at(Rows::volume, k) = fma(group.at(Rows::volume, k), trace, group.at(Rows::volume, k));
  }
}

CellGroup group_from(Ready& ready, Index first)
{
  return view_group(ready.model, ready.state, ready.work, first, first + pack_width);
}

void gather_cells(const SchemeContext& context, Ready& ready, Index first)
{
  const CellGroup group = group_from(ready, first);
  for (int c = 0; c < group.n(); ++c) map_mass_and_momentum(group, c);
  MpmGp::gather(context, group);
}

/// Ends the program if the two ways differ by more than round-off.
void compare(const std::vector<CornerSums<2>>& a, const std::vector<CornerSums<2>>& b, std::size_t n)
{
  Real scale = 0.0, most = 0.0;
  for (std::size_t slot = 0; slot < n; ++slot)
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) {
        scale = std::max(scale, std::abs(a[slot].internal_force[d][i]));
        most = std::max(most, std::abs(a[slot].internal_force[d][i] - b[slot].internal_force[d][i]));
      }
  if (most <= 1e-11 * scale) return;
  fmt::print(stderr, "the two ways differ: {} of {} N per m\n", most, scale);
  std::exit(1);
}

void GatherLanesAcrossPoints(benchmark::State& bench)
{
  Ready ready("mpm_gp", 0.1, static_cast<int>(bench.range(0)));
  const SchemeContext context{ready.model.method, ready.model.materials};
  const auto n = static_cast<Index>(ready.state.points.occupied().size());
  for (auto _ : bench)
    for (Index first = 0; first + pack_width <= n; first += pack_width) gather_cells(context, ready, first);
  count_points(bench, ready);
}
BENCHMARK(GatherLanesAcrossPoints)->Arg(rest)->Arg(flowing)->Unit(benchmark::kMicrosecond);

void GatherLanesAcrossCells(benchmark::State& bench)
{
  Ready ready("mpm_gp", 0.1, static_cast<int>(bench.range(0)));
  const SchemeContext context{ready.model.method, ready.model.materials};
  const std::vector<InterleavedCells> groups = make_groups(ready.state.points);
  std::vector<CornerSums<2>> corners(ready.work.corners.size());
  std::vector<Pack> pressure(groups.size());
  for (auto _ : bench)
    for (std::size_t k = 0; k < groups.size(); ++k) {
      GroupSums sums;
      map_group(groups[k], sums);
      pressure[k] = gather_group(ready.model.mesh->geometry(0), ready.model.method, groups[k], sums);
      spread(groups[k], sums, corners);
    }
  benchmark::DoNotOptimize(pressure.data());
  for (std::size_t k = 0; k < groups.size(); ++k) gather_cells(context, ready, static_cast<Index>(k) * pack_width);
  compare(ready.work.corners, corners, groups.size() * pack_width);
  count_points(bench, ready);
}
BENCHMARK(GatherLanesAcrossCells)->Arg(rest)->Arg(flowing)->Unit(benchmark::kMicrosecond);

void StrainLanesAcrossPoints(benchmark::State& bench)
{
  Ready ready("mpm_gp", 0.1, static_cast<int>(bench.range(0)));
  const auto n = static_cast<Index>(ready.state.points.occupied().size());
  for (auto _ : bench)
    for (Index first = 0; first + pack_width <= n; first += pack_width) {
      const CellGroup group = group_from(ready, first);
      const auto strain =
          strain_by_cell(strain_of_group(group, displacements(ready.model, ready.work.node, group), true));
      for (int c = 0; c < group.n(); ++c)
        for_each_block(group.points, group.cells[c], [&](const PointBlock<2>& block, Index) {
          for (Index p = 0; p < block.n; p += pack_width)
            scale_volume(block, p,
                accumulate_strain(block, p, strain_at_points(strain[c], right_half(block, p), upper_half(block, p))));
        });
    }
  count_points(bench, ready);
}
BENCHMARK(StrainLanesAcrossPoints)->Arg(rest)->Arg(flowing)->Unit(benchmark::kMicrosecond);

void StrainLanesAcrossCells(benchmark::State& bench)
{
  Ready ready("mpm_gp", 0.1, static_cast<int>(bench.range(0)));
  std::vector<InterleavedCells> groups = make_groups(ready.state.points);
  for (auto _ : bench)
    for (InterleavedCells& group : groups) {
      const auto by_cell = displacements(ready.model, ready.work.node, group_from(ready, group.slot[0]));
      std::array<PerCorner, 2> du;
      for (int d = 0; d < 2; ++d) du[d] = to_lanes([&](int c) { return by_cell[c][d].data(); });
      strain_group(ready.model.mesh->geometry(0), du, group);
    }
  count_points(bench, ready);
}
BENCHMARK(StrainLanesAcrossCells)->Arg(rest)->Arg(flowing)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace terp
