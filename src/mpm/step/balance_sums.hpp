// The sums over points that the balance of energy needs, eight points at a time.
// Not for: the walk over all points (totals), nor the balance (ledger).
#pragma once

#include "math/pack.hpp"
#include "mpm/points/soil_material.hpp"

#include <algorithm>

namespace terp {

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
