// Gradients of the shape functions at the material points themselves, for the integration of standard_mpm.
#pragma once

#include "mesh/cell_geometry.hpp"
#include "transfer/map_to_corners.hpp"

namespace terp {

/// dN_i/dx_d at eight places, shape [corner][d] [1/m].
inline std::array<std::array<Pack, 2>, 4> gradients_at(const CellGeometry<2>& cell, Pack xi, Pack eta)
{
  const auto j = jacobian(cell, xi, eta);
  const auto local = shape_derivatives(xi, eta);
  const Pack inverse_det = Pack(1.0) / (j[0][0] * j[1][1] - j[0][1] * j[1][0]);
  std::array<std::array<Pack, 2>, 4> gradient;
  for (int i = 0; i < 4; ++i) {
    gradient[i][0] = (j[1][1] * local[i][0] - j[1][0] * local[i][1]) * inverse_det;
    gradient[i][1] = (j[0][0] * local[i][1] - j[0][1] * local[i][0]) * inverse_det;
  }
  return gradient;
}

/// f_int,i += sum_p B_i(x_p)^T sigma_p Omega_p.
inline void add_internal_force_of_points(
    const CellGeometry<2>& cell, const PointBlock<2>& block, CornerSums<2>& corners)
{
  using Rows = PointRows<2>;
  std::array<std::array<Pack, 4>, 2> sums{zero_packs<4>(), zero_packs<4>()};
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto gradient =
        gradients_at(cell, Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p));
    const Pack volume = Pack::load(block.row(Rows::volume) + p);
    const Pack xx = volume * Pack::load(block.row(Rows::sigma) + p);
    const Pack yy = volume * Pack::load(block.row(Rows::sigma + 1) + p);
    const Pack xy = volume * Pack::load(block.row(Rows::sigma + 3) + p);
    for (int i = 0; i < 4; ++i) {
      sums[0][i] += fma(xx, gradient[i][0], xy * gradient[i][1]);
      sums[1][i] += fma(yy, gradient[i][1], xy * gradient[i][0]);
    }
  }
  for (int d = 0; d < 2; ++d) add_lanes(sums[d], corners.internal_force[d]);
}

/// Displacement gradient du_a/dx_b at eight points from du_i [m], shape [d][corner].
inline std::array<std::array<Pack, 2>, 2> displacement_gradient(
    const std::array<std::array<Pack, 2>, 4>& gradient, const CornerVectors& du)
{
  std::array<std::array<Pack, 2>, 2> l;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      l[a][b] = Pack(du[a][0]) * gradient[0][b];
      for (int i = 1; i < 4; ++i) l[a][b] = fma(Pack(du[a][i]), gradient[i][b], l[a][b]);
    }
  return l;
}

}  // namespace terp
