// What one cell adds to its nodes, and what its Gauss points hold; with packs in place of numbers that of eight cells,
// one per lane. Small arrays that stay in the first cache.
#pragma once

#include "materials/soil_material.hpp"
#include "points/point_blocks.hpp"

namespace terp {

/// A cell's own contributions to its corners; a node sums those of its cells in a fixed order.
template <int Dim, class R = Real>
struct CornerSums {
  std::array<R, n_corners<Dim>> mass;                             ///< m_i [kg per m]
  std::array<std::array<R, n_corners<Dim>>, Dim> momentum;        ///< (m v)_i [kg m/s per m]
  std::array<std::array<R, n_corners<Dim>>, Dim> internal_force;  ///< f_int of Eq. (4) [N per m]
};

/// Values at the Gauss points of the points of one block. What laws add to the points is kept beside it: GaussRow.
template <int Dim, class R = Real>
struct GaussValues {
  using PerGauss = std::array<R, n_corners<Dim>>;
  std::array<PerGauss, n_sym<Dim>> sigma;  ///< mean stress of the sub-cell, then sigma_hat of Eq. (3) [Pa]
  PerGauss volume;                         ///< sum of Omega_p in the sub-cell [m^2]
  PerGauss weight;                         ///< Omega_GP of Eqs. (2), (4) [m^2]
  R pressure;                              ///< p_e of Eq. (2) [Pa]
};

/// One row of the points at the Gauss points of eight cells: its sums over the sub-cells, then its means.
using GaussRow = std::array<Pack, n_corners<2>>;

/// Strain increments of one step at the Gauss points of a cell.
template <int Dim, class R = Real>
struct GaussStrain {
  using PerGauss = std::array<R, n_corners<Dim>>;
  std::array<PerGauss, n_sym<Dim>> d_eps;  ///< B-bar, tensorial shear [-]
  PerGauss d_spin;                         ///< (dv_y/dx - dv_x/dy) dt / 2 [-]
};

/// Chooses for each lane the value of its sub-cell: by the signs of xi and eta.
template <class R, class M>
R at_sub_cell(const std::array<Real, 4>& value, M right, M upper)
{
  return select(upper, select(right, R(value[3]), R(value[2])), select(right, R(value[1]), R(value[0])));
}

/// Ties of a point on a line between sub-cells go right and up (reading R7).
inline constexpr Real tie = 1e-9;

}  // namespace terp
