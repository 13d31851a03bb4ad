// What a ledger row needs of all points, from one walk over the blocks on the threads of the run.
// Part of the kernels: each copy walks with its own instructions; call by way of kernels() (kernels.hpp).
// Not for: what follows from it (ledger, failure).
#pragma once

#include "events/moved.hpp"
#include "events/surface.hpp"
#include "parallel/threads.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace terp {

inline constexpr int most_slopes = 2;  ///< a section falls to the left, to the right, or both

/// The strain and the strength of each point at the last ledger row; by id.
struct StrainMemory {
  std::vector<Real> last_eps_eq_p;
  std::vector<Real> last_su;  ///< S_u [Pa], or of soil with a softening length the strain that it follows [-]; empty
                              ///< where no material needs it: eps_eq_p alone tells S_u
};

/// What followers want of the walk over the points.
struct TotalsRequest {
  Real moved_distance = std::numeric_limits<Real>::infinity();  ///< from where on soil counts as moved [m]
  Ground ground = {};                                           ///< what may count as moved; empty: all
  std::vector<Columns> shear;                                   ///< in which the growth of strain counts, of each slope
  StrainMemory* memory = nullptr;  ///< none: neither growth nor audit. Of it the walk renews last_su alone
};

/// Sums and extremes over the points.
struct Totals {
  Real mass = 0.0;                                        ///< [kg per m]
  Vec<2> momentum{0.0, 0.0};                              ///< [N s per m]
  Real kinetic = 0.0, elastic = 0.0, pore_elastic = 0.0;  ///< of the points [J per m]
  Real v_max = 0.0, v_999 = 0.0;  ///< largest speed, and that which 99.9 % of the points do not exceed [m/s]
  MovedSoil moved;
  std::array<Real, most_slopes>
      growth{};  ///< growth of eps_eq_p since the last row, summed over the volume, of each slope [m^2]
  std::vector<std::size_t> fell, rose;  ///< ids of points whose eps_eq_p fell, whose S_u rose since the last row
  std::vector<std::uint8_t>
      strained;  ///< 1: eps_eq_p of some point of the block changed since the last row; by block number
};

/// Walks over all points. Sums go by chunks of cells in their order: the same bits on any number of threads. Of this
/// copy of the kernels: call by way of kernels().add_up.
Totals add_up_compiled(const Model& model, const State& state, Threads& threads, const TotalsRequest& request);

/// Energy stored per volume, of one point or of a pack of them. P: Real, or Pack where the points differ in stiffness.
template <class P>
struct ElasticEnergy {
  P half_over_bulk, quarter_over_shear;  // [1/Pa]; a fluid stores no shear

  ElasticEnergy(P over_bulk, P over_shear) : half_over_bulk(over_bulk), quarter_over_shear(over_shear) {}
  explicit ElasticEnergy(Moduli m) : ElasticEnergy(0.5 / m.bulk, m.shear > 0.0 ? 0.25 / m.shear : 0.0) {}

  template <class R>
  R operator()(R xx, R yy, R zz, R xy) const
  {
    const R p = (xx + yy + zz) * R(1.0 / 3.0), a = xx - p, b = yy - p, c = zz - p;
    return R(half_over_bulk) * p * p + R(quarter_over_shear) * (a * a + b * b + c * c + R(2.0) * xy * xy);
  }
};

/// Of the points p ... p + 7 of a block whose parameters vary; padding stores none.
inline ElasticEnergy<Pack> elastic_energy_of_points(const SoilMaterial& material, const PointBlock<2>& block, Index p)
{
  alignas(64) Real over_bulk[pack_width] = {}, over_shear[pack_width] = {};
  for (Index k = 0; k < std::min<Index>(pack_width, block.n - p); ++k) {
    const ElasticEnergy<Real> of_point(material.law->moduli(material.view(block, p + k)));
    over_bulk[k] = of_point.half_over_bulk;
    over_shear[k] = of_point.quarter_over_shear;
  }
  return {Pack::load(over_bulk), Pack::load(over_shear)};
}

/// Of the points p ... p + 7 of a block whose stiffness follows their stress, per volume.
inline Pack stored_energy_of_points(const SoilMaterial& material, const PointBlock<2>& block, Index p)
{
  alignas(64) Real energy[pack_width] = {};
  for (Index lane = p; lane < std::min<Index>(p + pack_width, block.n); ++lane)
    energy[lane - p] = material.law->stored_energy(material.view(block, lane), stress_at(block, lane));
  return Pack::load(energy);
}

/// Sums by lane. Lanes that hold no point have no mass and no volume.
struct BalanceSums {
  Pack mass{0.0}, momentum_x{0.0}, momentum_y{0.0}, twice_kinetic{0.0}, elastic{0.0}, pore_elastic{0.0};

  /// Adds the points p ... p + 7 of a block. energy: of the material if its parameters do not vary.
  void enter(const SoilMaterial& material, const ElasticEnergy<Real>& energy, const PointBlock<2>& block, Index p)
  {
    if (material.water_stiffness > 0.0) {
      const Pack excess = Pack::load(block.row(material.excess_row) + p);
      pore_elastic +=
          Pack::load(block.row(Rows::volume) + p) * (excess * excess * Pack(0.5 / material.water_stiffness));
    }
    if (material.type->stiffness_by_stress)
      enter([&](Pack, Pack, Pack, Pack) { return stored_energy_of_points(material, block, p); }, block, p);
    else if (material.varies())
      enter(elastic_energy_of_points(material, block, p), block, p);
    else
      enter(energy, block, p);
  }

 private:
  template <class Energy>
  void enter(const Energy& energy, const PointBlock<2>& block, Index p)
  {
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
