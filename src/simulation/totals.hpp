// What a ledger row needs of all points, from one walk over the blocks on the threads of the run.
// Part of the kernels: each copy walks with its own instructions; call by way of kernels() (kernels.hpp).
// Not for: what follows from it (ledger, failure).
#pragma once

#include "events/moved.hpp"
#include "parallel/threads.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace terp {

inline constexpr int most_slopes = 2;  ///< a section falls to the left, to the right, or both

/// Sums and extremes over the points.
struct Totals {
  Real mass = 0.0;                    ///< [kg per m]
  Vec<2> momentum{0.0, 0.0};          ///< [N s per m]
  Real kinetic = 0.0, elastic = 0.0;  ///< of the points [J per m]
  Real v_max = 0.0, v_999 = 0.0;      ///< largest speed, and that which 99.9 % of the points do not exceed [m/s]
  MovedSoil moved;
  std::array<Real, most_slopes>
      growth{};  ///< growth of eps_eq_p since the last row, summed over the volume, of each slope [m^2]
  std::vector<std::size_t> fell, rose;  ///< ids of points whose eps_eq_p fell, whose S_u rose since the last row
  std::vector<std::uint8_t>
      strained;  ///< 1: eps_eq_p of some point of the block changed since the last row; by block number
};

/// Walks over all points. Sums go by chunks of cells in their order: the same bits on any number of threads. Of what
/// the audit remembers only last_su is renewed. moved_distance: from where on soil counts as moved [m]; shear: columns
/// of each slope in which growth counts. Of this copy of the kernels: call by way of kernels().add_up.
Totals add_up_compiled(
    const Model& model, State& state, Threads& threads, Real moved_distance, std::span<const Columns> shear);

/// Energy stored per volume, of one point or of a pack of them.
struct ElasticEnergy {
  Real half_over_bulk, quarter_over_shear;  // [1/Pa]; a fluid stores no shear
  explicit ElasticEnergy(const Material& law)
      : half_over_bulk(0.5 / law.bulk_modulus()),
        quarter_over_shear(law.shear_modulus() > 0.0 ? 0.25 / law.shear_modulus() : 0.0)
  {
  }

  template <class R>
  R operator()(R xx, R yy, R zz, R xy) const
  {
    const R p = (xx + yy + zz) * R(1.0 / 3.0), a = xx - p, b = yy - p, c = zz - p;
    return R(half_over_bulk) * p * p + R(quarter_over_shear) * (a * a + b * b + c * c + R(2.0) * xy * xy);
  }
};

/// Sums by lane. Lanes that hold no point have no mass and no volume.
struct Books {
  Pack mass{0.0}, momentum_x{0.0}, momentum_y{0.0}, twice_kinetic{0.0}, elastic{0.0};

  /// Adds the points p ... p + 7 of a block.
  void enter(const ElasticEnergy& energy, const PointBlock<2>& block, Index p)
  {
    using Rows = PointRows<2>;
    const auto at = [&](int r) { return Pack::load(block.row(r) + p); };
    const Pack m = at(Rows::mass), vx = at(Rows::v), vy = at(Rows::v + 1);
    mass += m;
    momentum_x += m * vx;
    momentum_y += m * vy;
    twice_kinetic += m * (vx * vx + vy * vy);
    elastic +=
        at(Rows::volume) * energy(at(Rows::sigma), at(Rows::sigma + 1), at(Rows::sigma + 2), at(Rows::sigma + 3));
  }
};

}  // namespace terp
