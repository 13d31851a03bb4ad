// The force of what holds the weight of points while their body is placed or dug away (run/loop/placed_bodies).
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "mpm/kernels/cell_sums.hpp"
#include "mpm/kernels/held_shares.hpp"

namespace terp {

/// Share of each of eight points. held: their row, 1: placed, -1: dug away, 0: neither.
inline Pack held_share(Pack held, const HeldShares& shares)
{
  return select(held > Pack(0.0), Pack(shares.placed), select(held < Pack(0.0), Pack(shares.removed), Pack(0.0)));
}

/// Of the volume of a block.
inline Real mean_held_share(const PointBlock<2>& block, int row, const HeldShares& shares)
{
  Pack held(0.0), all(0.0);
  for (Index p = 0; p < block.n; p += pack_width) {
    const Pack volume = Pack::load(block.row(Rows::volume) + p);
    held = fma(volume, held_share(Pack::load(block.row(row) + p), shares), held);
    all += volume;
  }
  return sum(held) / sum(all);
}

/// f_i += N_i(x_p) share_p (V_p grad p - m_p g): what the points weigh in their water, the other way round.
///
/// row       of the points: 1: placed, -1: dug away, 0: neither
/// gravity   [m/s^2]
/// gradient  of the pressure in the water, in this cell [Pa/m]
template <class Element>
inline void map_held_weight(const PointBlock<2>& block, int row, const HeldShares& shares, Vec<2> gravity,
    Vec<2> gradient, CornerVectors<Element>& force)
{
  for (Index p = 0; p < block.n; p += pack_width) {
    const Mask in_use = lane_numbers() < Pack(static_cast<Real>(block.n - p));
    const Pack share = select(in_use, held_share(Pack::load(block.row(row) + p), shares), Pack(0.0));
    if (to_bits((share > Pack(0.0)) | (share < Pack(0.0))) == 0) continue;
    const auto N = Element::shape_functions(load_rows<2>(block, Rows::xi, p));
    const Pack mass = Pack::load(block.row(Rows::mass) + p), volume = Pack::load(block.row(Rows::volume) + p);
    for (int d = 0; d < 2; ++d) {
      const Pack pull = share * (volume * Pack(gradient[d]) - mass * Pack(gravity[d]));
      for (int i = 0; i < Element::n_corners; ++i) force[d][i] += sum(select(in_use, N[i] * pull, Pack(0.0)));
    }
  }
}

}  // namespace terp
