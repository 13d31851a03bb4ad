// Gradients of the shape functions at the material points themselves, for the integration of standard_mpm.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "math/tensor.hpp"
#include "mpm/mesh/cell_geometry.hpp"
#include "mpm/kernels/map_to_corners.hpp"

namespace terp {

/// dN_i/dx_d at eight places, shape [corner][d] [1/m].
template <class Element>
inline PerCorner<Element, PerDirection<Element, Pack>> gradients_at(
    const CellGeometry<Element>& cell, const PerDirection<Element, Pack>& local)
{
  const auto j = Element::jacobian(cell.map, local);
  const auto derivatives = Element::shape_derivatives(local);
  const Pack inverse_det = Pack(1.0) / Element::determinant(j);
  PerCorner<Element, PerDirection<Element, Pack>> gradient;
  for (int i = 0; i < Element::n_corners; ++i) {
    gradient[i] = Element::scaled_gradient(j, derivatives[i]);
    for (Pack& component : gradient[i]) component *= inverse_det;
  }
  return gradient;
}

/// f_int,i += sum_p B_i(x_p)^T sigma_p Omega_p.
template <class Element>
inline void add_internal_force_of_points(
    const CellGeometry<Element>& cell, const PointBlock<Element::dim>& block, CornerSums<Element>& corners)
{
  constexpr int dim = Element::dim;
  static_assert(dim == 2, "xx yy zz xy");
  using Rows = PointRows<dim>;
  CornerVectors<Element, Pack> sums;
  sums.fill(zero_packs<Element::n_corners>());
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto gradient = gradients_at(cell, load_rows<dim>(block, Rows::xi, p));
    const Pack volume = Pack::load(block.row(Rows::volume) + p);
    const Pack xx = volume * Pack::load(block.row(Rows::sigma) + p);
    const Pack yy = volume * Pack::load(block.row(Rows::sigma + 1) + p);
    const Pack xy = volume * Pack::load(block.row(Rows::sigma + 3) + p);
    for (int i = 0; i < Element::n_corners; ++i) {
      sums[0][i] += fma(xx, gradient[i][0], xy * gradient[i][1]);
      sums[1][i] += fma(yy, gradient[i][1], xy * gradient[i][0]);
    }
  }
  for (int d = 0; d < dim; ++d) add_lanes(sums[d], corners.internal_force[d]);
}

/// Displacement gradient du_a/dx_b at eight points from du_i [m], shape [d][corner].
template <std::size_t dim, std::size_t n>
inline std::array<std::array<Pack, dim>, dim> displacement_gradient(
    const std::array<std::array<Pack, dim>, n>& gradient, const std::array<std::array<Real, n>, dim>& du)
{
  std::array<std::array<Pack, dim>, dim> l;
  for (std::size_t a = 0; a < dim; ++a)
    for (std::size_t b = 0; b < dim; ++b) {
      l[a][b] = Pack(du[a][0]) * gradient[0][b];
      for (std::size_t i = 1; i < n; ++i) l[a][b] = fma(Pack(du[a][i]), gradient[i][b], l[a][b]);
    }
  return l;
}

/// (l + l^T) / 2; out of the plane zero.
template <std::size_t dim>
inline SymTensor<Pack, dim> symmetric_part(const std::array<std::array<Pack, dim>, dim>& l)
{
  SymTensor<Pack, dim> d_eps;
  d_eps.c.fill(Pack(0.0));
  for (std::size_t a = 0; a < dim; ++a) {
    d_eps[a] = l[a][a];
    for (std::size_t b = a + 1; b < dim; ++b) d_eps[component_of(a, b)] = (l[a][b] + l[b][a]) * Pack(0.5);
  }
  return d_eps;
}

}  // namespace terp
