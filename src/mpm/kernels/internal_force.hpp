// Internal force of a cell, Eq. (4), and its counterpart, the strain increment at the Gauss points.
// One text for a cell and for eight in packs: R is Real or Pack, Geometry CellGeometry or GeometryLanes.
// With B-bar (reading R5) the volumetric part takes the gradients of the cell's centre, in both: work-conjugate (R4).
#pragma once

#include "math/tensor.hpp"
#include "mpm/mesh/cell_geometry.hpp"
#include "mpm/kernels/map_to_corners.hpp"
#include "mpm/kernels/method_options.hpp"

namespace terp {

/// f_int,i += sum_g B-bar_i^T sigma_hat_g Omega_g, Eq. (4); without B-bar plain B.
template <class Geometry, class Element, class R>
void add_internal_force(
    const Geometry& cell, const GaussValues<Element, R>& gauss, bool b_bar, CornerSums<Element, R>& corners)
{
  constexpr int dim = Element::dim;
  auto force = gauss.sigma;  // conjugate to the gradients at g: stress times weight
  R centre(0.0);             // conjugate to the gradients at the centre: sum of p_g w_g
  for (int g = 0; g < Element::n_gauss; ++g) {
    const R w = gauss.weight[g];
    const R p = b_bar ? (gauss.sigma[0][g] + gauss.sigma[1][g] + gauss.sigma[2][g]) * R(1.0 / 3.0) : R(0.0);
    for (int k = 0; k < n_sym<dim>; ++k) force[k][g] = w * (k < 3 ? gauss.sigma[k][g] - p : gauss.sigma[k][g]);
    centre += w * p;
  }
  for (int i = 0; i < Element::n_corners; ++i)
    for (int d = 0; d < dim; ++d) {
      R f = centre * cell.centre_gradient[i][d];
      for (int g = 0; g < Element::n_gauss; ++g) {
        R at_g = force[component_of(d, 0)][g] * cell.gradient[i][0][g];
        for (int e = 1; e < dim; ++e) at_g += force[component_of(d, e)][g] * cell.gradient[i][e][g];
        f += at_g;
      }
      corners.internal_force[d][i] += f;
    }
}

/// Strain increment and spin at the Gauss points from displacements du_i = v_i dt [m], shape [d][corner]. Step 2 of
/// Sec. 2.1: d_eps + (theta_0 - tr d_eps)/3 I with theta_0 = tr d_eps(0), so d_eps_zz is not zero (R5). theta_0 is the
/// volume change.
template <class Geometry, class R, class Element = typename Geometry::Element>
GaussStrain<Element, R> strain_at_gauss_points(const Geometry& cell, const CornerVectors<Element, R>& du, bool b_bar)
{
  constexpr int dim = Element::dim;
  static_assert(dim == 2, "one component of spin");
  R theta_0(0.0);
  for (int i = 0; i < Element::n_corners; ++i) {
    R trace = du[0][i] * cell.centre_gradient[i][0];
    for (int d = 1; d < dim; ++d) trace += du[d][i] * cell.centre_gradient[i][d];
    theta_0 += trace;
  }
  GaussStrain<Element, R> strain;
  for (int g = 0; g < Element::n_gauss; ++g) {
    auto l = repeat<dim>(repeat<dim>(R(0.0)));  // du_a/dx_b, shape [a][b]
    for (int i = 0; i < Element::n_corners; ++i)
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b) l[a][b] += du[a][i] * cell.gradient[i][b][g];
    R trace = l[0][0];
    for (int d = 1; d < dim; ++d) trace += l[d][d];
    const R correction = b_bar ? (theta_0 - trace) * R(1.0 / 3.0) : R(0.0);
    for (int k = 0; k < 3; ++k) strain.d_eps[k][g] = correction;
    for (int d = 0; d < dim; ++d) strain.d_eps[d][g] = l[d][d] + correction;
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b) strain.d_eps[component_of(a, b)][g] = R(0.5) * (l[a][b] + l[b][a]);
    strain.d_spin[g] = R(0.5) * (l[1][0] - l[0][1]);
  }
  return strain;
}

}  // namespace terp
