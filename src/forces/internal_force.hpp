// Internal force of a cell, Eq. (4), and its counterpart, the strain increment at the Gauss points.
// One text for a cell and for eight in packs: R is Real or Pack, Geometry CellGeometry<2> or GeometryLanes.
// With B-bar (reading R5) the volumetric part takes the gradients of the cell's centre, in both: work-conjugate (R4).
#pragma once

#include "mesh/cell_geometry.hpp"
#include "transfer/map_to_corners.hpp"
#include "transfer/method_options.hpp"

namespace terp {

/// f_int,i += sum_g B-bar_i^T sigma_hat_g Omega_g, Eq. (4); with ForceOperator::b plain B.
template <class Geometry, class R>
void add_internal_force(
    const Geometry& cell, const GaussValues<2, R>& gauss, ForceOperator op, CornerSums<2, R>& corners)
{
  const bool b_bar = op == ForceOperator::b_bar;
  std::array<R, 4> xx, yy, xy;  // stress conjugate to the gradients at g, times the weight
  R centre(0.0);                // sum of p_g w_g: conjugate to the gradients at the centre
  for (int g = 0; g < 4; ++g) {
    const R w = gauss.weight[g];
    const R p = b_bar ? (gauss.sigma[0][g] + gauss.sigma[1][g] + gauss.sigma[2][g]) * R(1.0 / 3.0) : R(0.0);
    xx[g] = w * (gauss.sigma[0][g] - p);
    yy[g] = w * (gauss.sigma[1][g] - p);
    xy[g] = w * gauss.sigma[3][g];
    centre += w * p;
  }
  for (int i = 0; i < 4; ++i) {
    const auto &gx = cell.gradient[i][0], &gy = cell.gradient[i][1];
    R fx = centre * cell.centre_gradient[i][0], fy = centre * cell.centre_gradient[i][1];
    for (int g = 0; g < 4; ++g) {
      fx += xx[g] * gx[g] + xy[g] * gy[g];
      fy += yy[g] * gy[g] + xy[g] * gx[g];
    }
    corners.internal_force[0][i] += fx;
    corners.internal_force[1][i] += fy;
  }
}

/// Strain increment and spin at the Gauss points from displacements du_i = v_i dt [m], shape [d][corner]. Step 2 of
/// Sec. 2.1: d_eps + (theta_0 - tr d_eps)/3 I with theta_0 = tr d_eps(0), so d_eps_zz is not zero (R5). theta_0 is the
/// volume change.
template <class Geometry, class R>
GaussStrain<2, R> strain_at_gauss_points(const Geometry& cell, const CornerVectorsOf<R>& du, bool b_bar)
{
  GaussStrain<2, R> strain;
  std::array<R, 4> xx, yy, xy, yx;
  for (auto* component : {&xx, &yy, &xy, &yx}) component->fill(R(0.0));
  R theta_0(0.0);
  for (int i = 0; i < 4; ++i) {
    const auto &gx = cell.gradient[i][0], &gy = cell.gradient[i][1];
    theta_0 += du[0][i] * cell.centre_gradient[i][0] + du[1][i] * cell.centre_gradient[i][1];
    for (int g = 0; g < 4; ++g) {
      xx[g] += du[0][i] * gx[g];
      xy[g] += du[0][i] * gy[g];
      yx[g] += du[1][i] * gx[g];
      yy[g] += du[1][i] * gy[g];
    }
  }
  for (int g = 0; g < 4; ++g) {
    const R correction = b_bar ? (theta_0 - (xx[g] + yy[g])) * R(1.0 / 3.0) : R(0.0);
    strain.d_eps[0][g] = xx[g] + correction;
    strain.d_eps[1][g] = yy[g] + correction;
    strain.d_eps[2][g] = correction;
    strain.d_eps[3][g] = R(0.5) * (xy[g] + yx[g]);
    strain.d_spin[g] = R(0.5) * (yx[g] - xy[g]);
  }
  return strain;
}

}  // namespace terp
