#include "transfer/gauss_average.hpp"

#include "parallel/lanes.hpp"

namespace terp {
namespace {

using PerGauss = GaussValues<2>::PerGauss;

/// Omega_p of the lanes that lie in each sub-cell, zero elsewhere.
std::array<Pack, 4> split_volume(Pack xi, Pack eta, Pack volume)
{
  const Mask right = xi >= Pack(-tie), upper = eta >= Pack(-tie);
  const Pack zero(0.0);
  const Pack in_upper = select(upper, volume, zero), in_lower = select(upper, zero, volume);
  return {select(right, zero, in_lower), select(right, in_lower, zero), select(right, zero, in_upper),
      select(right, in_upper, zero)};
}

/// Sub-cell sums of Omega_p -> volume, and of N rows from `first` on, times Omega_p -> out[row][g].
template <int N>
void sum_rows(const PointBlock<2>& block, int first, PerGauss* volume, PerGauss* out)
{
  using Rows = PointRows<2>;
  std::array<std::array<Pack, 4>, N> sums;
  sums.fill(zero_packs<4>());
  auto volume_sums = zero_packs<4>();
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto part = split_volume(Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p),
        Pack::load(block.row(Rows::volume) + p));
    for (int g = 0; g < 4; ++g) volume_sums[g] += part[g];
    for (int r = 0; r < N; ++r) {
      const Pack value = Pack::load(block.row(first + r) + p);
      for (int g = 0; g < 4; ++g) sums[r][g] = fma(value, part[g], sums[r][g]);
    }
  }
  if (volume != nullptr) *volume = sum_each(volume_sums);
  for (int r = 0; r < N; ++r) out[r] = sum_each(sums[r]);
}

}  // namespace

void sum_over_sub_cells(const PointBlock<2>& block, GaussValues<2>& gauss)
{
  sum_rows<n_sym<2>>(block, PointRows<2>::sigma, &gauss.volume, gauss.sigma.data());
}

std::array<Real, 4> sum_row_over_sub_cells(const PointBlock<2>& block, int row)
{
  std::array<Real, 4> sums;
  sum_rows<1>(block, row, nullptr, &sums);
  return sums;
}

}  // namespace terp
