// What a scheme sees of a cell it works on, and what schemes share of the work on points.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "math/tensor.hpp"
#include "mpm/kernels/internal_force.hpp"
#include "mpm/kernels/pore_pressure.hpp"
#include "mpm/points/soil_material.hpp"
#include "mpm/mesh/mesh.hpp"
#include "mpm/kernels/gauss_average.hpp"
#include "mpm/kernels/map_held_weight.hpp"

#include <algorithm>
#include <vector>

namespace terp {

/// Choices and laws: the same for every cell of a run.
struct SchemeContext {
  const MethodOptions& method;
  const std::vector<SoilMaterial>& materials;
  Real dt = 0.0;                       ///< length of the step [s]
  int inverse_extent = -1;             ///< row of the points, where cells count in patches
  int work_row = -1;                   ///< row of the points: plastic work of the last step; -1: nobody asks
  const PorePressure* pore = nullptr;  ///< on the nodes; nullptr: none
  bool all_drains = false;             ///< no soil is undrained
  Real drained_keeps = 1.0;            ///< part of what it was pressed with that drained soil keeps in this step
  const Mesh<2>* mesh = nullptr;       ///< of laws that look around
  Vec<2> gravity{0.0, 0.0};            ///< [m/s^2]
  HeldShares held = {};                ///< of the weight that is held
  int held_row = -1;                   ///< of the points; -1: none is held
  Real time = 0.0;                     ///< at the start of the step [s]
  std::int64_t step = 0;
  Real at_strength = 1.0;  ///< strengths at the end of the step are those of the laws divided by this [-]
};

/// One occupied cell.
template <class Element>
struct CellView {
  Index cell;
  const CellGeometry<Element>& geometry;
  PointBlocks<Element::dim>& points;
  CornerSums<Element>& corners;
};

/// The pore pressure at the corners of a cell, for soil of one material.
template <class Element>
CornerPore<Element> pore_at_corners(
    const PorePressure& pore, const std::array<Index, Element::n_corners>& corners, bool stores_effective)
{
  CornerPore<Element> at;
  for (int i = 0; i < Element::n_corners; ++i) {
    at.pressure[i] = pore.pressure[corners[i]];
    at.inside[i] = !stores_effective ? at.pressure[i] : pore.suction.empty() ? 0.0 : pore.suction[corners[i]];
  }
  return at;
}

/// Of which grad p pulls at points: without its limits, where the stress is effective; as the nodes have it, where the
/// stored stress holds p too.
template <class Element>
PerCorner<Element> pull_at_corners(
    const PorePressure& pore, const std::array<Index, Element::n_corners>& corners, bool stores_effective)
{
  const std::vector<Real>& of_nodes = stores_effective ? pore.unlimited : pore.pressure;
  PerCorner<Element> at;
  for (int i = 0; i < Element::n_corners; ++i) at[i] = of_nodes[corners[i]];
  return at;
}

/// What the stress pass adds up for the ledger [J per m].
struct StressSums {
  Real plastic_work = 0.0;  ///< of the laws
  Real slip_work = 0.0;     ///< lost on borders between soils
  Pack taken{0.0};          ///< by the points: their stress at the start of the step on their strain, by lanes
  Pack reset{0.0};          ///< gained by stored energy as the pressure of that start is set (reading R10), by lanes

  /// Of eight points: the stress that they begin the step with. omega: their volumes.
  template <int Dim>
  void take(const SymTensor<Pack, Dim>& sigma, const SymTensor<Pack, Dim>& d_eps, Pack omega)
  {
    taken = fma(omega, double_dot(sigma, d_eps), taken);
  }
  /// Of eight points: their pressure at the start is set. half_compliance: 1/(2K) [1/Pa].
  void set_pressure(Pack half_compliance, Pack omega, Pack before, Pack after)
  {
    reset = fma(half_compliance * omega, (after - before) * (after + before), reset);
  }
};

/// 1/(2K) of the points of a block. Zero where the stiffness follows the stress: there a pressure stores in proportion
/// to itself, so that a mean keeps the energy.
class HalfCompliance {
 public:
  explicit HalfCompliance(const SoilMaterial& material)
      : material_(material),
        varies_(material.varies() && !material.type->stiffness_by_stress),
        of_all_(material.type->stiffness_by_stress ? 0.0 : 0.5 / material.law->bulk_modulus())
  {
  }
  /// Of the points p ... p + 7.
  Pack at(const PointBlock<2>& block, Index p) const
  {
    if (!varies_) return of_all_;
    alignas(64) Real values[pack_width];
    material_.law->half_compliance(material_.view(block, p), block.n - p, values);
    return Pack::load(values);
  }

 private:
  const SoilMaterial& material_;
  bool varies_;
  Pack of_all_;
};

/// Points that one call of Material::update takes at most: its arrays stay in the first cache.
inline constexpr Index strip_length = 8 * pack_width;

/// Strain increments and plastic work of a strip of points.
template <int Dim>
struct alignas(64) StripArrays {
  Real d_eps[n_sym<Dim>][strip_length];
  Real plastic_work[strip_length];
  Real d_spin[strip_length];  ///< set where a law looks around
};

template <int Dim>
inline void store_strain(const SymTensor<Pack, Dim>& d_eps, StripArrays<Dim>& strip, Index at)
{
  for (int k = 0; k < n_sym<Dim>; ++k) d_eps[k].store(strip.d_eps[k] + at);
}

template <int Dim>
inline SymTensor<Pack, Dim> strain_of(const StripArrays<Dim>& strip, Index at)
{
  SymTensor<Pack, Dim> d_eps;
  for (int k = 0; k < n_sym<Dim>; ++k) d_eps[k] = Pack::load(strip.d_eps[k] + at);
  return d_eps;
}

inline bool looks_around(const SchemeContext& context, Index material)
{
  return context.materials[material].type->looks_around;
}

/// What a law sees around the points of a block from `first` on.
template <int Dim>
inline Surroundings<Dim> surroundings_of(
    const SchemeContext& context, const PointBlock<Dim>& block, Index first, const Real* d_spin, const Real& cell_size)
{
  using Rows = PointRows<Dim>;
  Surroundings<Dim> around{.time = context.time,
      .step = context.step,
      .cells = {&block.cell, 1},
      .cell_sizes = {&cell_size, 1},
      .d_spin = d_spin,
      .turned = context.method.objective_rate == ObjectiveRate::jaumann,
      .id = block.row(Rows::id) + first};
  for (int d = 0; d < Dim; ++d) around.x[d] = block.row(Rows::x + d) + first;
  return around;
}

/// Runs the law on n entries of a block from point `first` on, padding included.
template <int Dim>
inline void update_strip(
    const SchemeContext& context, const PointBlock<Dim>& block, Index first, Index n, StripArrays<Dim>& strip)
{
  const SoilMaterial& material = context.materials[block.material];
  StressArrays<Dim> arrays{};
  for (int k = 0; k < n_sym<Dim>; ++k) arrays.sigma[k] = block.row(PointRows<Dim>::sigma + k) + first;
  for (int k = 0; k < n_sym<Dim>; ++k) arrays.d_eps[k] = strip.d_eps[k];
  arrays.law = material.view(block, first);
  arrays.plastic_work = strip.plastic_work;
  arrays.n = n;
  arrays.n_points = block.n - first;
  arrays.dt = context.dt;
  arrays.at_strength = context.at_strength;
  alignas(64) Real scale[strip_length];
  if (!material.softening_scale.empty()) {
    std::fill_n(scale, n, material.softening_scale[block.cell]);
    arrays.softening_scale = scale;
  }
  Surroundings<Dim> around;
  Real cell_size = 0.0;
  if (material.type->looks_around) {
    cell_size = std::sqrt(context.mesh->geometry(block.cell).volume);
    around = surroundings_of(context, block, first, strip.d_spin, cell_size);
    arrays.around = &around;
  }
  material.law->update(arrays);
  if (context.work_row >= 0) std::copy_n(strip.plastic_work, n, block.row(context.work_row) + first);
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
template <int Dim>
inline Real sum_plastic_work(const PointBlock<Dim>& block, Index first, Index n, const StripArrays<Dim>& strip)
{
  Pack work(0.0);
  for (Index p = 0; p < n; p += pack_width)
    work = fma(Pack::load(block.row(PointRows<Dim>::volume) + first + p), Pack::load(strip.plastic_work + p), work);
  return sum(work);
}

/// Adds a strain increment to the accumulated strain of eight points and returns its trace.
template <int Dim>
inline Pack accumulate_strain(const PointBlock<Dim>& block, Index p, const SymTensor<Pack, Dim>& d_eps)
{
  for (int k = 0; k < n_sym<Dim>; ++k) {
    Real* strain = block.row(PointRows<Dim>::strain + k) + p;
    (Pack::load(strain) + d_eps[k]).store(strain);
  }
  return trace(d_eps);
}

/// Omega_p *= 1 + tr d_eps.
template <int Dim>
inline void scale_volume(const PointBlock<Dim>& block, Index p, Pack volumetric_strain)
{
  Real* volume = block.row(PointRows<Dim>::volume) + p;
  const Pack old = Pack::load(volume);
  fma(old, volumetric_strain, old).store(volume);
}

/// The strain increments of a strip, added to eight points of the block and their volume.
template <int Dim>
inline void add_strain(const PointBlock<Dim>& block, Index p, const StripArrays<Dim>& strip, Index at)
{
  scale_volume(block, p, accumulate_strain(block, p, strain_of(strip, at)));
}

template <int Dim>
inline SymTensor<Pack, Dim> stress_of(const PointBlock<Dim>& block, Index p)
{
  return {load_rows<n_sym<Dim>>(block, PointRows<Dim>::sigma, p)};
}

/// Mean stress of eight points.
template <int Dim>
inline Pack mean_stress(const PointBlock<Dim>& block, Index p)
{
  return trace(stress_of(block, p)) * Pack(1.0 / 3.0);
}

/// The strain increment of each point's own Gauss point (reading R11). upper: halves of the cell that eight points are
/// in.
template <class Element>
inline SymTensor<Pack, Element::dim> strain_at_points(
    const GaussStrain<Element>& strain, const PerDirection<Element, Mask>& upper)
{
  SymTensor<Pack, Element::dim> d_eps;
  for (int k = 0; k < n_sym<Element::dim>; ++k) d_eps[k] = Element::at_sub_cell(strain.d_eps[k], upper);
  return d_eps;
}

/// What the points of a block have above what is around them, as a mean.
struct MeanAbove {
  Pack above = Pack(0.0), volume = Pack(0.0);  ///< sums over points, times Omega_p

  void add(const PointBlock<2>& block, Index p, Pack own, Pack around)
  {
    const Pack omega = Pack::load(block.row(PointRows<2>::volume) + p);
    above = fma(omega, own - around, above);
    volume += omega;
  }
  Pack operator()() const { return Pack(sum(above) / sum(volume)); }
};

/// The halves of their cell that the points p ... p + 7 are in.
template <class Element>
inline PerDirection<Element, Mask> upper_halves(const PointBlock<Element::dim>& block, Index p)
{
  return Element::upper_halves(load_rows<Element::dim>(block, PointRows<Element::dim>::xi, p));
}

}  // namespace terp
