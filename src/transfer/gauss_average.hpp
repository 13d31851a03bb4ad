// Material points to Gauss points: means over sub-cells, integration weights and the cell's pressure, Eqs. (1) to (3).
// After the sums over points one text serves a cell and eight in packs: R is Real or Pack, Geometry CellGeometry<2> or
// GeometryLanes.
#pragma once

#include "mesh/cell_geometry.hpp"
#include "transfer/cell_sums.hpp"
#include "transfer/method_options.hpp"

namespace terp {

/// Sums over each sub-cell of one block: Omega_p -> gauss.volume, sigma_p Omega_p -> gauss.sigma. The denominator and
/// the numerators of Eq. (1).
void sum_over_sub_cells(const PointBlock<2>& block, GaussValues<2>& gauss);

/// The same of one row alpha: sum of alpha_p Omega_p, shape [g].
std::array<Real, 4> sum_row_over_sub_cells(const PointBlock<2>& block, int row);

template <class R>
R total(const std::array<R, 4>& a)
{
  return (a[0] + a[1]) + (a[2] + a[3]);
}

template <class R>
R weighted_mean(const std::array<R, 4>& value, const std::array<R, 4>& weight)
{
  return ((value[0] * weight[0] + value[1] * weight[1]) + (value[2] * weight[2] + value[3] * weight[3])) /
         total(weight);
}

/// 1 where the points fill the cell up to `filled_fraction` at least (reading R3), else 0.
template <class Geometry, class R>
R filled_share(const Geometry& cell, R volume, const MethodOptions& method)
{
  const R excess = volume / R(cell.volume) - R(method.filled_fraction);
  return select(excess >= R(0.0), R(1.0), R(0.0));
}

/// Integration weights of one block (reading R3): w_g detJ in a filled cell, shared between blocks by volume; the
/// points' own volume otherwise. cell_volume: sum over all blocks of the cell, shape [g].
template <class Geometry, class R>
void set_weights(
    const Geometry& cell, const std::array<R, 4>& cell_volume, const MethodOptions& method, GaussValues<2, R>& gauss)
{
  const R all = total(cell_volume), own = total(gauss.volume);
  R filled = filled_share(cell, all, method);
  if (method.weights == Weights::summed) filled = R(0.0);
  if (method.weights == Weights::gauss) filled = R(1.0);
  for (int g = 0; g < 4; ++g) {
    const R share = select(cell_volume[g] > R(0.0), gauss.volume[g] / cell_volume[g], own / all);
    gauss.weight[g] = filled * share * R(cell.gauss_volume[g]) + (R(1.0) - filled) * gauss.volume[g];
  }
}

/// Turns sums over the sub-cells into means, Eq. (1). An empty sub-cell takes the block's mean (reading R8).
template <class R>
class SubCellMeans {
 public:
  explicit SubCellMeans(const std::array<R, 4>& volume) : volume_(volume), all_(total(volume))
  {
    for (int g = 0; g < 4; ++g) inverse_[g] = R(1.0) / volume[g];
  }

  void operator()(std::array<R, 4>& value) const
  {
    const R mean = total(value) / all_;
    for (int g = 0; g < 4; ++g) value[g] = select(volume_[g] > R(0.0), value[g] * inverse_[g], mean);
  }

 private:
  std::array<R, 4> volume_, inverse_;
  R all_;
};

/// Turns the sums of the stress into means, Eq. (1).
template <class R>
void divide_by_volume(GaussValues<2, R>& gauss)
{
  const SubCellMeans<R> mean(gauss.volume);
  for (auto& component : gauss.sigma) mean(component);
}

/// p_e by Eq. (2) and sigma_hat by Eq. (3).
template <class R>
void smooth_pressure(GaussValues<2, R>& gauss)
{
  std::array<R, 4> p;
  for (int g = 0; g < 4; ++g) p[g] = (gauss.sigma[0][g] + gauss.sigma[1][g] + gauss.sigma[2][g]) * R(1.0 / 3.0);
  gauss.pressure = weighted_mean(p, gauss.weight);  // Eq. (2)
  for (int k = 0; k < 3; ++k)
    for (int g = 0; g < 4; ++g) gauss.sigma[k][g] -= p[g] - gauss.pressure;  // Eq. (3)
}

/// Replaces a value at all Gauss points by its mean over the cell with the weights of Eq. (2).
template <class R>
void average_over_cell(const std::array<R, 4>& weight, std::array<R, 4>& value)
{
  value.fill(weighted_mean(value, weight));
}

}  // namespace terp
