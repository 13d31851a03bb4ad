// Points to the corners of their cell and back: mass, momentum, velocity increments. Pure sums over one block.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "math/lanes.hpp"
#include "mpm/kernels/cell_sums.hpp"

namespace terp {

/// Least share of a point that a corner of its cell gets. A point exactly on a side gives the corners across nothing;
/// with this they have its velocity, and do not stand still and strain the cell (decision 0027). Far below the
/// round-off of any mass.
inline constexpr Real least_share = 1e-30;

/// N_i, at least `least_share`; not a number stays so.
template <class Element>
inline PerCorner<Element, Pack> mapping_shares(const PerDirection<Element, Pack>& local)
{
  auto N = Element::shape_functions(local);
  for (Pack& share : N) share = max(Pack(least_share), share);
  return N;
}

/// corners[i] += sum of the lanes of sums[i].
template <std::size_t n>
inline void add_lanes(const std::array<Pack, n>& sums, std::array<Real, n>& corners)
{
  const std::array<Real, n> each = sum_each(sums);
  for (std::size_t i = 0; i < n; ++i) corners[i] += each[i];
}

/// m_i += sum N_i m_p; (m v)_i += sum N_i m_p v_p.
template <class Element>
inline void map_mass_and_momentum(const PointBlock<Element::dim>& block, CornerSums<Element>& corners)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  auto mass = zero_packs<Element::n_corners>();
  auto momentum = zero_packs<dim, Element::n_corners>();
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto N = mapping_shares<Element>(load_rows<dim>(block, Rows::xi, p));
    const Pack m = Pack::load(block.row(Rows::mass) + p);
    const auto v = load_rows<dim>(block, Rows::v, p);
    for (int i = 0; i < Element::n_corners; ++i) {
      const Pack weight = N[i] * m;
      mass[i] += weight;
      for (int d = 0; d < dim; ++d) momentum[d][i] = fma(weight, v[d], momentum[d][i]);
    }
  }
  add_lanes(mass, corners.mass);
  for (int d = 0; d < dim; ++d) add_lanes(momentum[d], corners.momentum[d]);
}

/// (m v)_i += sum N_i m_p v_p, with the updated velocities (MUSL).
template <class Element>
inline void map_momentum(const PointBlock<Element::dim>& block, CornerSums<Element>& corners)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  auto momentum = zero_packs<dim, Element::n_corners>();
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto N = mapping_shares<Element>(load_rows<dim>(block, Rows::xi, p));
    const Pack m = Pack::load(block.row(Rows::mass) + p);
    auto momentum_p = load_rows<dim>(block, Rows::v, p);
    for (Pack& component : momentum_p) component = m * component;
    for (int i = 0; i < Element::n_corners; ++i)
      for (int d = 0; d < dim; ++d) momentum[d][i] = fma(N[i], momentum_p[d], momentum[d][i]);
  }
  for (int d = 0; d < dim; ++d) add_lanes(momentum[d], corners.momentum[d]);
}

/// sum_i N_i a_i at eight points.
template <std::size_t dim, std::size_t n>
inline std::array<Pack, dim> interpolate(const std::array<std::array<Real, n>, dim>& a, const std::array<Pack, n>& N)
{
  std::array<Pack, dim> value;
  for (std::size_t d = 0; d < dim; ++d) {
    value[d] = N[0] * Pack(a[d][0]);
    for (std::size_t i = 1; i < n; ++i) value[d] = fma(N[i], Pack(a[d][i]), value[d]);
  }
  return value;
}

/// v_p += dt sum N_i a_i (FLIP); with flip < 1 blended with sum N_i v*_i (PIC). Returns the kinetic energy that
/// blending adds [J per m], as a rule below zero.
///
/// dv        dt a_i [m/s], v_star  v* of the nodes [m/s]
template <class Element>
inline Real accelerate_points(
    const CornerVectors<Element>& dv, const CornerVectors<Element>& v_star, Real flip, PointBlock<Element::dim>& block)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  Pack twice_gained(0.0);
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto N = Element::shape_functions(load_rows<dim>(block, Rows::xi, p));
    const auto increment = interpolate(dv, N);
    auto v = load_rows<dim>(block, Rows::v, p);
    for (int d = 0; d < dim; ++d) v[d] += increment[d];
    if (flip < 1.0) {
      const auto pic = interpolate(v_star, N);
      const Pack mass = Pack::load(block.row(Rows::mass) + p);
      for (int d = 0; d < dim; ++d) {
        const Pack free = v[d];
        v[d] = fma(Pack(flip), free, Pack(1.0 - flip) * pic[d]);
        twice_gained = fma(mass, (v[d] - free) * (v[d] + free), twice_gained);
      }
    }
    store_rows(v, block, Rows::v, p);
  }
  return flip < 1.0 ? 0.5 * sum(twice_gained) : 0.0;
}

}  // namespace terp
