#include "mpm/kernels/gauss_average.hpp"

#include "mpm/points/rows_of_packs.hpp"
#include "math/lanes.hpp"

namespace terp {
namespace {

/// Sub-cell sums of Omega_p -> volume, and of N rows from `first` on, times Omega_p -> out[row][g].
template <class Element, int N>
void sum_rows(const PointBlock<Element::dim>& block, int first, PerGauss<Element>* volume, PerGauss<Element>* out)
{
  using Rows = PointRows<Element::dim>;
  constexpr int n_gauss = Element::n_gauss;
  std::array<PerGauss<Element, Pack>, N> sums;
  sums.fill(zero_packs<n_gauss>());
  auto volume_sums = zero_packs<n_gauss>();
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto upper = Element::upper_halves(load_rows<Element::dim>(block, Rows::xi, p));
    const auto part = Element::in_sub_cell(Pack::load(block.row(Rows::volume) + p), upper);
    for (int g = 0; g < n_gauss; ++g) volume_sums[g] += part[g];
    for (int r = 0; r < N; ++r) {
      const Pack value = Pack::load(block.row(first + r) + p);
      for (int g = 0; g < n_gauss; ++g) sums[r][g] = fma(value, part[g], sums[r][g]);
    }
  }
  if (volume != nullptr) *volume = sum_each(volume_sums);
  for (int r = 0; r < N; ++r) out[r] = sum_each(sums[r]);
}

}  // namespace

template <class Element>
void sum_over_sub_cells(const PointBlock<Element::dim>& block, GaussValues<Element>& gauss)
{
  constexpr int dim = Element::dim;
  sum_rows<Element, n_sym<dim>>(block, PointRows<dim>::sigma, &gauss.volume, gauss.sigma.data());
}

template <class Element>
PerGauss<Element> sum_row_over_sub_cells(const PointBlock<Element::dim>& block, int row)
{
  PerGauss<Element> sums;
  sum_rows<Element, 1>(block, row, nullptr, &sums);
  return sums;
}

template void sum_over_sub_cells(const PointBlock<2>& block, GaussValues<Quad4>& gauss);
template PerGauss<Quad4> sum_row_over_sub_cells<Quad4>(const PointBlock<2>& block, int row);

}  // namespace terp
