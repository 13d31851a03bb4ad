// Material points to Gauss points: means over sub-cells, integration weights and the cell's pressure, Eqs. (1) to (3).
// After the sums over points one text serves a cell and eight in packs: R is Real or Pack, Geometry CellGeometry or
// GeometryLanes.
#pragma once

#include "mpm/mesh/cell_geometry.hpp"
#include "mpm/kernels/cell_sums.hpp"
#include "mpm/kernels/method_options.hpp"

namespace terp {

/// Sums over each sub-cell of one block: Omega_p -> gauss.volume, sigma_p Omega_p -> gauss.sigma. The denominator and
/// the numerators of Eq. (1).
template <class Element>
void sum_over_sub_cells(const PointBlock<Element::dim>& block, GaussValues<Element>& gauss);

/// The same of one row alpha: sum of alpha_p Omega_p, shape [g].
template <class Element>
PerGauss<Element> sum_row_over_sub_cells(const PointBlock<Element::dim>& block, int row);

/// The sum of n terms from `first` on, in pairs: (t0 + t1) + (t2 + t3). term: of a number.
template <std::size_t n, class Term>
auto sum_in_pairs(const Term& term, std::size_t first = 0)
{
  if constexpr (n == 1)
    return term(first);
  else
    return sum_in_pairs<n / 2>(term, first) + sum_in_pairs<n / 2>(term, first + n / 2);
}

template <class R, std::size_t n>
R total(const std::array<R, n>& a)
{
  return sum_in_pairs<n>([&](std::size_t g) { return a[g]; });
}

template <class R, std::size_t n>
R weighted_mean(const std::array<R, n>& value, const std::array<R, n>& weight)
{
  return sum_in_pairs<n>([&](std::size_t g) { return value[g] * weight[g]; }) / total(weight);
}

/// 1 where the weights are those of a filled cell: its points fill at least `filled_fraction` of it (reading R3), else
/// 0.
template <class Geometry, class R>
R filled_share(const Geometry& cell, R volume, const MethodOptions& method)
{
  if (method.weights == Weights::summed) return R(0.0);
  const R excess = volume / R(cell.volume) - R(method.filled_fraction);
  return select(excess >= R(0.0), R(1.0), R(0.0));
}

/// Integration weights of one block (reading R3): w_g detJ in a filled cell, shared between blocks by volume; the
/// points' own volume otherwise. cell_volume: sum over all blocks of the cell, shape [g].
template <class Geometry, class Element, class R>
void set_weights(const Geometry& cell, const PerGauss<Element, R>& cell_volume, const MethodOptions& method,
    GaussValues<Element, R>& gauss)
{
  const R all = total(cell_volume), own = total(gauss.volume);
  const R filled = filled_share(cell, all, method);
  for (int g = 0; g < Element::n_gauss; ++g) {
    const R share = select(cell_volume[g] > R(0.0), gauss.volume[g] / cell_volume[g], own / all);
    gauss.weight[g] = filled * share * R(cell.gauss_volume[g]) + (R(1.0) - filled) * gauss.volume[g];
  }
}

/// Turns sums over the sub-cells into means, Eq. (1). An empty sub-cell takes the block's mean (reading R8).
template <class Element, class R>
class SubCellMeans {
 public:
  explicit SubCellMeans(const GaussValues<Element, R>& gauss) : volume_(gauss.volume), all_(total(gauss.volume))
  {
    for (int g = 0; g < Element::n_gauss; ++g) inverse_[g] = R(1.0) / volume_[g];
  }

  void operator()(PerGauss<Element, R>& value) const
  {
    const R mean = total(value) / all_;
    for (int g = 0; g < Element::n_gauss; ++g) value[g] = select(volume_[g] > R(0.0), value[g] * inverse_[g], mean);
  }

 private:
  PerGauss<Element, R> volume_, inverse_;
  R all_;
};

/// Turns the sums of the stress into means, Eq. (1).
template <class Element, class R>
void divide_by_volume(GaussValues<Element, R>& gauss)
{
  const SubCellMeans mean(gauss);
  for (auto& component : gauss.sigma) mean(component);
}

/// p_e by Eq. (2) and sigma_hat by Eq. (3).
template <class Element, class R>
void smooth_pressure(GaussValues<Element, R>& gauss)
{
  PerGauss<Element, R> p;
  for (int g = 0; g < Element::n_gauss; ++g)
    p[g] = (gauss.sigma[0][g] + gauss.sigma[1][g] + gauss.sigma[2][g]) * R(1.0 / 3.0);
  gauss.pressure = weighted_mean(p, gauss.weight);  // Eq. (2)
  for (int k = 0; k < 3; ++k)
    for (int g = 0; g < Element::n_gauss; ++g) gauss.sigma[k][g] -= p[g] - gauss.pressure;  // Eq. (3)
}

/// Replaces a value at all Gauss points by its mean over the cell with the weights of Eq. (2).
template <class R, std::size_t n>
void average_over_cell(const std::array<R, n>& weight, std::array<R, n>& value)
{
  value.fill(weighted_mean(value, weight));
}

}  // namespace terp
