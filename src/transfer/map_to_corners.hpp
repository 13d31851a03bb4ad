// Points to the corners of their cell and back: mass, momentum, velocity increments. Pure sums over one block.
#pragma once

#include "mesh/shape_functions.hpp"
#include "parallel/lanes.hpp"
#include "transfer/cell_sums.hpp"

namespace terp {

/// Least share of a point that a corner of its cell gets. A point exactly on a side gives the corners across nothing;
/// with this they have its velocity, and do not stand still and strain the cell (decision 0027). Far below the
/// round-off of any mass.
inline constexpr Real least_share = 1e-30;

/// N_i, at least `least_share`; not a number stays so.
inline std::array<Pack, 4> mapping_shares(Pack xi, Pack eta)
{
  std::array<Pack, 4> N = shape_functions(xi, eta);
  for (Pack& share : N) share = max(Pack(least_share), share);
  return N;
}

/// corners[i] += sum of the lanes of sums[i].
inline void add_lanes(const std::array<Pack, 4>& sums, std::array<Real, 4>& corners)
{
  const std::array<Real, 4> each = sum_each(sums);
  for (int i = 0; i < 4; ++i) corners[i] += each[i];
}

/// m_i += sum N_i m_p; (m v)_i += sum N_i m_p v_p.
inline void map_mass_and_momentum(const PointBlock<2>& block, CornerSums<2>& corners)
{
  using Rows = PointRows<2>;
  auto mass = zero_packs<4>(), momentum_x = mass, momentum_y = mass;
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto N = mapping_shares(Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p));
    const Pack m = Pack::load(block.row(Rows::mass) + p);
    const Pack vx = Pack::load(block.row(Rows::v) + p), vy = Pack::load(block.row(Rows::v + 1) + p);
    for (int i = 0; i < 4; ++i) {
      const Pack weight = N[i] * m;
      mass[i] += weight;
      momentum_x[i] = fma(weight, vx, momentum_x[i]);
      momentum_y[i] = fma(weight, vy, momentum_y[i]);
    }
  }
  add_lanes(mass, corners.mass);
  add_lanes(momentum_x, corners.momentum[0]);
  add_lanes(momentum_y, corners.momentum[1]);
}

/// (m v)_i += sum N_i m_p v_p, with the updated velocities (MUSL).
inline void map_momentum(const PointBlock<2>& block, CornerSums<2>& corners)
{
  using Rows = PointRows<2>;
  auto momentum_x = zero_packs<4>(), momentum_y = momentum_x;
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto N = mapping_shares(Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p));
    const Pack m = Pack::load(block.row(Rows::mass) + p);
    const Pack px = m * Pack::load(block.row(Rows::v) + p), py = m * Pack::load(block.row(Rows::v + 1) + p);
    for (int i = 0; i < 4; ++i) {
      momentum_x[i] = fma(N[i], px, momentum_x[i]);
      momentum_y[i] = fma(N[i], py, momentum_y[i]);
    }
  }
  add_lanes(momentum_x, corners.momentum[0]);
  add_lanes(momentum_y, corners.momentum[1]);
}

/// Nodal values of one cell's corners, or in packs those of eight cells, shape [d][corner].
template <class R>
using CornerVectorsOf = std::array<std::array<R, 4>, 2>;
using CornerVectors = CornerVectorsOf<Real>;

/// sum_i N_i a_i at eight points.
inline std::array<Pack, 2> interpolate(const CornerVectors& a, const std::array<Pack, 4>& N)
{
  std::array<Pack, 2> value;
  for (int d = 0; d < 2; ++d) {
    value[d] = N[0] * Pack(a[d][0]);
    for (int i = 1; i < 4; ++i) value[d] = fma(N[i], Pack(a[d][i]), value[d]);
  }
  return value;
}

/// v_p += dt sum N_i a_i (FLIP); with flip < 1 blended with sum N_i v*_i (PIC).
///
/// dv        dt a_i [m/s], v_star  v* of the nodes [m/s]
inline void accelerate_points(const CornerVectors& dv, const CornerVectors& v_star, Real flip, PointBlock<2>& block)
{
  using Rows = PointRows<2>;
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto N = shape_functions(Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p));
    const auto increment = interpolate(dv, N);
    std::array<Pack, 2> v;
    for (int d = 0; d < 2; ++d) v[d] = Pack::load(block.row(Rows::v + d) + p) + increment[d];
    if (flip < 1.0) {
      const auto pic = interpolate(v_star, N);
      for (int d = 0; d < 2; ++d) v[d] = fma(Pack(flip), v[d], Pack(1.0 - flip) * pic[d]);
    }
    for (int d = 0; d < 2; ++d) v[d].store(block.row(Rows::v + d) + p);
  }
}

}  // namespace terp
