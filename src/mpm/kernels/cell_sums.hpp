// What one cell adds to its nodes, and what its Gauss points hold; with packs in place of numbers that of eight cells,
// one per lane. Small arrays that stay in the first cache.
#pragma once

#include "mpm/points/soil_material.hpp"
#include "mpm/mesh/element.hpp"
#include "mpm/points/point_blocks.hpp"

namespace terp {

/// A vector at each corner of one cell, or in packs of eight cells, shape [d][corner].
template <class Element, class R = Real>
using CornerVectors = PerDirection<Element, PerCorner<Element, R>>;

/// A vector at each corner of each of eight cells, shape [cell][d][corner].
template <class Element>
using GroupVectors = std::array<CornerVectors<Element>, pack_width>;

/// dN_i/dx_d whose sum with the velocities is the volume change of a cell [1/m], one lane per cell.
template <class Element>
using VolumeGradient = PerCorner<Element, PerDirection<Element, Pack>>;

/// A cell's own contributions to its corners; a node sums those of its cells in a fixed order.
template <class Element, class R = Real>
struct CornerSums {
  PerCorner<Element, R> mass;                ///< m_i [kg per m]
  CornerVectors<Element, R> momentum;        ///< (m v)_i [kg m/s per m]
  CornerVectors<Element, R> internal_force;  ///< f_int of Eq. (4) [N per m]
};

/// Values at the Gauss points of the points of one block. What laws add to the points is kept beside it: GaussRow.
template <class Element, class R = Real>
struct GaussValues {
  std::array<PerGauss<Element, R>, n_sym<Element::dim>>
      sigma;                    ///< mean stress of the sub-cell, then sigma_hat of Eq. (3) [Pa]
  PerGauss<Element, R> volume;  ///< sum of Omega_p in the sub-cell [m^2]
  PerGauss<Element, R> weight;  ///< Omega_GP of Eqs. (2), (4) [m^2]
  R pressure;                   ///< p_e of Eq. (2) [Pa]
};

/// One row of the points at the Gauss points of eight cells: its sums over the sub-cells, then its means.
template <class Element>
using GaussRow = PerGauss<Element, Pack>;

/// Strain increments of one step at the Gauss points of a cell.
template <class Element, class R = Real>
struct GaussStrain {
  std::array<PerGauss<Element, R>, n_sym<Element::dim>> d_eps;  ///< B-bar, tensorial shear [-]
  PerGauss<Element, R> d_spin;                                  ///< (dv_y/dx - dv_x/dy) dt / 2 [-]
};

}  // namespace terp
