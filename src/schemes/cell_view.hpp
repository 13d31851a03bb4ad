// What a scheme sees of a cell it works on, and what schemes share of the work on points.
#pragma once

#include "base/tensor.hpp"
#include "forces/internal_force.hpp"
#include "forces/point_gradients.hpp"
#include "materials/soil_material.hpp"
#include "transfer/gauss_average.hpp"

#include <algorithm>
#include <vector>

namespace terp {

/// Choices and laws: the same for every cell of a run.
struct SchemeContext {
  const MethodOptions& method;
  const std::vector<SoilMaterial>& materials;
  Real dt = 0.0;  ///< length of the step [s]
};

/// One occupied cell.
struct CellView {
  Index cell;
  const CellGeometry<2>& geometry;
  PointBlocks<2>& points;
  CornerSums<2>& corners;
};

/// What the stress pass adds up for the ledger.
struct StressSums {
  Real plastic_work = 0.0;  ///< [J per m]
};

/// Points that one call of Material::update takes at most: its arrays stay in the first cache.
inline constexpr Index strip_length = 8 * pack_width;

/// Strain increments and plastic work of a strip of points.
struct alignas(64) StripArrays {
  Real d_eps[n_sym<2>][strip_length];
  Real plastic_work[strip_length];
};

/// Runs the law on n entries of a block from point `first` on, padding included.
inline void update_strip(
    const SchemeContext& context, const PointBlock<2>& block, Index first, Index n, StripArrays& strip)
{
  const SoilMaterial& material = context.materials[block.material];
  StressArrays<2> arrays{};
  for (int k = 0; k < n_sym<2>; ++k) arrays.sigma[k] = block.row(PointRows<2>::sigma + k) + first;
  for (int k = 0; k < n_sym<2>; ++k) arrays.d_eps[k] = strip.d_eps[k];
  arrays.law = material.view(block, first);
  arrays.plastic_work = strip.plastic_work;
  arrays.n = n;
  arrays.n_points = block.n - first;
  arrays.dt = context.dt;
  material.law->update(arrays);
}

/// First-order Jaumann rotation: sigma += w sigma - sigma w, w = d_spin of the step (reading R17).
template <class R>
void rotate_stress(SymTensor<R, 2>& sigma, R d_spin)
{
  const R shear = sigma[3] * d_spin;
  const R difference = sigma[0] - sigma[1];
  sigma[0] = sigma[0] - R(2.0) * shear;
  sigma[1] = sigma[1] + R(2.0) * shear;
  sigma[3] = sigma[3] + difference * d_spin;
}

/// Sum of Omega_p times plastic work per volume over a strip [J per m].
inline Real sum_plastic_work(const PointBlock<2>& block, Index first, Index n, const StripArrays& strip)
{
  Pack work(0.0);
  for (Index p = 0; p < n; p += pack_width)
    work = fma(Pack::load(block.row(PointRows<2>::volume) + first + p), Pack::load(strip.plastic_work + p), work);
  return sum(work);
}

/// Adds a strain increment to the accumulated strain of eight points and returns its trace.
inline Pack accumulate_strain(const PointBlock<2>& block, Index p, const SymTensor<Pack, 2>& d_eps)
{
  for (int k = 0; k < n_sym<2>; ++k) {
    Real* strain = block.row(PointRows<2>::strain + k) + p;
    (Pack::load(strain) + d_eps[k]).store(strain);
  }
  return trace(d_eps);
}

/// Omega_p *= 1 + tr d_eps.
inline void scale_volume(const PointBlock<2>& block, Index p, Pack volumetric_strain)
{
  Real* volume = block.row(PointRows<2>::volume) + p;
  const Pack old = Pack::load(volume);
  fma(old, volumetric_strain, old).store(volume);
}

/// The strain increment of each point's own Gauss point (reading R11).
inline SymTensor<Pack, 2> strain_at_points(const GaussStrain<2>& strain, Mask right, Mask upper)
{
  SymTensor<Pack, 2> d_eps;
  for (int k = 0; k < n_sym<2>; ++k) d_eps[k] = at_sub_cell<Pack>(strain.d_eps[k], right, upper);
  return d_eps;
}

inline Mask right_half(const PointBlock<2>& block, Index p)
{
  return Pack::load(block.row(PointRows<2>::xi) + p) >= Pack(-tie);
}
inline Mask upper_half(const PointBlock<2>& block, Index p)
{
  return Pack::load(block.row(PointRows<2>::xi + 1) + p) >= Pack(-tie);
}

}  // namespace terp
