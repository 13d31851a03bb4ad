#include "transfer/gauss_average.hpp"

#include <algorithm>

namespace terp {
namespace {

using PerGauss = GaussValues<2>::PerGauss;

Real total(const PerGauss& a) { return (a[0] + a[1]) + (a[2] + a[3]); }

Real weighted_mean(const PerGauss& value, const PerGauss& weight, Real total_weight)
{
  return ((value[0] * weight[0] + value[1] * weight[1]) + (value[2] * weight[2] + value[3] * weight[3])) / total_weight;
}

/// Omega_p of the lanes that lie in each sub-cell, zero elsewhere.
std::array<Pack, 4> split_volume(Pack xi, Pack eta, Pack volume)
{
  const Mask right = xi >= Pack(-tie), upper = eta >= Pack(-tie);
  const Pack zero(0.0);
  const Pack in_upper = select(upper, volume, zero), in_lower = select(upper, zero, volume);
  return {select(right, zero, in_lower), select(right, in_lower, zero), select(right, zero, in_upper), select(right, in_upper, zero)};
}

/// Adds the sub-cell sums of N rows, starting at `first`, to out[row][g].
template <int N>
void sum_rows(const PointBlock<2>& block, int first, std::array<Real, 4>* out)
{
  using Rows = PointRows<2>;
  std::array<std::array<Pack, 4>, N> sums;
  for (auto& row : sums)
    for (Pack& s : row) s = Pack(0.0);
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto part = split_volume(Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p),
                                   Pack::load(block.row(Rows::volume) + p));
    for (int r = 0; r < N; ++r) {
      const Pack value = Pack::load(block.row(first + r) + p);
      for (int g = 0; g < 4; ++g) sums[r][g] = fma(value, part[g], sums[r][g]);
    }
  }
  for (int r = 0; r < N; ++r)
    for (int g = 0; g < 4; ++g) out[r][g] = sum(sums[r][g]);
}

void sum_volume(const PointBlock<2>& block, PerGauss& volume)
{
  using Rows = PointRows<2>;
  std::array<Pack, 4> sums{Pack(0.0), Pack(0.0), Pack(0.0), Pack(0.0)};
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto part = split_volume(Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p),
                                   Pack::load(block.row(Rows::volume) + p));
    for (int g = 0; g < 4; ++g) sums[g] += part[g];
  }
  for (int g = 0; g < 4; ++g) volume[g] = sum(sums[g]);
}

}  // namespace

void sum_over_sub_cells(const PointBlock<2>& block, int n_state, GaussValues<2>& gauss)
{
  using Rows = PointRows<2>;
  sum_volume(block, gauss.volume);
  sum_rows<n_sym<2>>(block, Rows::sigma, gauss.sigma.data());
  for (int k = 0; k < n_state; ++k) sum_rows<1>(block, Rows::state + k, &gauss.state[k]);
}

Real filled_share(const CellGeometry<2>& cell, Real volume, const MethodOptions& method)
{
  const Real excess = volume / cell.volume - method.filled_fraction;
  if (method.filled_blend == 0.0) return excess >= 0.0 ? 1.0 : 0.0;
  return std::clamp(0.5 + 0.5 * excess / method.filled_blend, 0.0, 1.0);
}

void set_weights(const CellGeometry<2>& cell, const std::array<Real, 4>& cell_volume, const MethodOptions& method,
                 GaussValues<2>& gauss)
{
  const Real all = total(cell_volume), own = total(gauss.volume);
  Real filled = filled_share(cell, all, method);
  if (method.weights == Weights::summed) filled = 0.0;
  if (method.weights == Weights::gauss) filled = 1.0;
  for (int g = 0; g < 4; ++g) {
    const Real share = cell_volume[g] > 0.0 ? gauss.volume[g] / cell_volume[g] : own / all;
    gauss.weight[g] = filled * share * cell.gauss_volume[g] + (1.0 - filled) * gauss.volume[g];
  }
}

void divide_by_volume(int n_state, GaussValues<2>& gauss)
{
  const Real all = total(gauss.volume);
  PerGauss inverse;
  for (int g = 0; g < 4; ++g) inverse[g] = gauss.volume[g] > 0.0 ? 1.0 / gauss.volume[g] : 0.0;
  const auto divide = [&](PerGauss& value) {
    const Real mean = total(value) / all;
    for (int g = 0; g < 4; ++g) value[g] = gauss.volume[g] > 0.0 ? value[g] * inverse[g] : mean;
  };
  for (auto& component : gauss.sigma) divide(component);
  for (int k = 0; k < n_state; ++k) divide(gauss.state[k]);
}

bool smooth_pressure(bool part_filled, const MethodOptions& method, GaussValues<2>& gauss)
{
  PerGauss p;
  for (int g = 0; g < 4; ++g) p[g] = (gauss.sigma[0][g] + gauss.sigma[1][g] + gauss.sigma[2][g]) * (1.0 / 3.0);
  gauss.pressure = weighted_mean(p, gauss.weight, total(gauss.weight));  // Eq. (2)
  const bool cut = part_filled && gauss.pressure > method.tension_limit;
  if (cut) gauss.pressure = method.tension_limit;
  for (int k = 0; k < 3; ++k)
    for (int g = 0; g < 4; ++g) gauss.sigma[k][g] -= p[g] - gauss.pressure;  // Eq. (3)
  return cut;
}

void average_state_over_cell(int k, GaussValues<2>& gauss)
{
  const Real mean = weighted_mean(gauss.state[k], gauss.weight, total(gauss.weight));
  gauss.state[k].fill(mean);
}

}  // namespace terp
