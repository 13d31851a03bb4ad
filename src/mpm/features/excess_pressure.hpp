// Excess pore pressure u of undrained soil that stores effective stress: from the points to the cells and back, as the
// pressure of a total stress would go. docs/methods.md, "Water".
//
//   u_g = sum_p s_pg u_p Omega_p / sum_p s_pg Omega_p       as Eq. (1)
//   u_e = sum_g u_g Omega_g / sum_g Omega_g                 as Eq. (2); the force takes it as Eq. (3) does
//   u_p <- u_e - (K_w/n) tr(d_eps_p)                        as reading R10, by way of u_p + (u_e - u_p)
//
// In drained soil K_w/n is zero, and u_p times the part that the step keeps.
#pragma once

#include "mpm/features/excess.hpp"
#include "mpm/features/patch_group.hpp"
#include "mpm/features/patch_rows.hpp"
#include "mpm/step/now.hpp"

namespace terp {

/// One row of the sums of the blocks of a layer at their Gauss points, with shares that overlap.
template <class Element>
GaussRow<Element> collect_row(const CellGroup<Element>& group, PatchValues& patches, const BlockLayer& layer, int row)
{
  const GaussRows sums = collect_sums(group, patches, layer, row);
  GaussRow<Element> values;
  for (int g = 0; g < Element::n_gauss; ++g) values[g] = sums[g][0];
  return values;
}

/// u_e of the cells of a layer [Pa], one lane per cell; keeps them by block.
inline Pack gather_excess(LayerNow& now)
{
  const CellGroup<Quad4>& group = now.at.group;
  StepNow& step = now.at.step;
  GaussRow<Quad4> excess = step.context.inverse_extent < 0 ? sum_row(group, now.layer, now.material.excess_row)
                                                           : collect_row(group, patches_of(step.work), now.layer,
                                                                 patches_of(step.work).excess_place);
  const SubCellMeans mean(now.gauss);
  mean(excess);
  const Pack of_cell = weighted_mean(excess, now.gauss.weight);
  for (int c = 0; c < group.n(); ++c)
    if (now.layer.block[c] >= 0) step.work.with.excess->pressure[now.layer.block[c]] = of_cell[c];
  return of_cell;
}

/// Soil stores the energy of its excess pressure, which is then part of its stress: u^2/(2 K_w/n) per volume. Where it
/// drains, u is a pressure from outside.
inline bool stores_excess(const SchemeContext& context, const SoilMaterial& material)
{
  return material.water_stiffness > 0.0 && !context.all_drains;
}

/// What a step does to the excess pressure of a material.
class ExcessStep {
 public:
  ExcessStep(const SchemeContext& context, const SoilMaterial& material) : stores_(stores_excess(context, material))
  {
    kept_ = stores_ ? 1.0 : context.drained_keeps;
    stiffness_ = stores_ ? material.water_stiffness : 0.0;
    half_compliance_ = stores_ ? 0.5 / material.water_stiffness : 0.0;
  }
  /// The new one of eight points. own: theirs; around: what it is set to at the start of the step.
  Pack operator()(Pack own, Pack around, Pack volumetric_strain, Pack omega, StressSums& sums) const
  {
    const Pack start = own + (around - own);
    if (stores_) {
      sums.taken -= omega * start * volumetric_strain;
      sums.set_pressure(half_compliance_, omega, own, start);
    }
    return kept_ * start - stiffness_ * volumetric_strain;
  }

 private:
  bool stores_;
  Pack kept_{}, stiffness_{}, half_compliance_{};
};

/// New excess pressure of the points of a block. of_cell: u_e [Pa]; strain: of their cell. Before the volumes change.
template <class Element>
void update_excess(const SchemeContext& context, const PointBlock<Element::dim>& block, Real of_cell,
    const GaussStrain<Element>& strain, StressSums& sums)
{
  const SoilMaterial& material = context.materials[block.material];
  const ExcessStep step(context, material);
  for (Index p = 0; p < block.n; p += pack_width) {
    Real* at = block.row(material.excess_row) + p;
    const Pack volumetric = trace(strain_at_points(strain, upper_halves<Element>(block, p)));
    step(Pack::load(at), of_cell, volumetric, Pack::load(block.row(PointRows<Element::dim>::volume) + p), sums)
        .store(at);
  }
}

/// The same with shares that overlap, of schemes whose Gauss points own the history. excess: row of patch that is u_e.
inline void update_excess_from_patch(const SchemeContext& context, const PointBlock<2>& block, const PatchSize& size,
    const PatchView& patch, int excess, StressSums& sums)
{
  using Element = Quad4;
  const SoilMaterial& material = context.materials[block.material];
  const ExcessStep step(context, material);
  const auto inverse_of = [&](const auto& shares) {
    return inverse_ratio(context, patch.at_points<1>(shares, HistoryRows::ratio)[0]);
  };
  Pack above(0.0), volume(0.0);  // of the points, above that around them; as their pressure keeps its mean
  for (Index p = 0; p < block.n; p += pack_width)
    with_shares(block, p, size, [&](const auto& shares) {
      const Pack omega = Pack::load(block.row(PointRows<Element::dim>::volume) + p);
      const Pack own = Pack::load(block.row(material.excess_row) + p);
      above = fma(omega, own - inverse_of(shares) * patch.at_points<1>(shares, excess)[0], above);
      volume += omega;
    });
  const Pack shift(sum(above) / sum(volume));
  for (Index p = 0; p < block.n; p += pack_width)
    with_shares(block, p, size, [&](const auto& shares) {
      Real* at = block.row(material.excess_row) + p;
      const auto direct = patch.at_points<3>(shares, HistoryRows::strain);
      const Pack inverse = inverse_of(shares), around = inverse * patch.at_points<1>(shares, excess)[0] + shift;
      const Pack omega = Pack::load(block.row(PointRows<Element::dim>::volume) + p);
      step(Pack::load(at), around, inverse * (direct[0] + direct[1] + direct[2]), omega, sums).store(at);
    });
}

}  // namespace terp
