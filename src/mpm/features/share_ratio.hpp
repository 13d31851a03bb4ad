// The way back from Gauss points to points as the transpose of the way there: strain of a Gauss point counts by its
// weight in the force, Omega_g, over the volume that the points left there, W_g. A sub-cell of a filled cell that no
// point reaches has weight but no point; the other sub-cells of the block take its strain (decision 0066):
//
//   e       = sum_{h: W_h = 0} Omega_h / sum_g W_g
//   left_g  = Omega_g/W_g d_eps_g + sum_{h: W_h = 0} Omega_h d_eps_h / sum_g W_g
//   d_eps_p = sum_g s_pg left_g / sum_g s_pg (Omega_g/W_g + e)
//
// Not for: the shares s_pg (mpm/kernels/overlap.hpp); with point shares a point has one, of its own sub-cell.
#pragma once

#include "mpm/schemes/cell_group.hpp"

#include <algorithm>

namespace terp {

/// Of the Gauss points of a block: Omega_g/W_g [-]; where no point is near, -Omega_g / sum W, which is not positive.
template <class Element, class R = Real>
using ShareRatios = PerGauss<Element, R>;

/// Keeps the ratios of the blocks of a layer. gauss: sums of the volume, and weights.
template <class Element>
void keep_ratios(std::span<ShareRatios<Element>> kept, const BlockLayer& layer, const GaussValues<Element, Pack>& gauss)
{
  const Pack inverse_all = Pack(1.0) / total(gauss.volume);
  ShareRatios<Element, Pack> ratios;
  for (int g = 0; g < Element::n_gauss; ++g)
    ratios[g] =
        gauss.weight[g] * select(gauss.volume[g] > Pack(0.0), Pack(1.0) / gauss.volume[g], Pack(0.0) - inverse_all);
  std::array<ShareRatios<Element>, pack_width> of_cells;
  from_lanes(ratios, [&](int c) { return of_cells[c].data(); });
  for (int c = 0; c < pack_width; ++c)
    if (layer.block[c] >= 0) kept[layer.block[c]] = of_cells[c];
}

/// The same, one lane per cell; 1 where there is no block.
template <class Element>
ShareRatios<Element, Pack> ratios_of(std::span<const ShareRatios<Element>> kept, const BlockLayer& layer)
{
  static constexpr ShareRatios<Element> none{1.0, 1.0, 1.0, 1.0};
  return to_lanes([&](int c) { return (layer.block[c] < 0 ? none : kept[layer.block[c]]).data(); });
}

/// What the Gauss points of one block, or of eight, hand back.
template <class Element, class R>
class ShareRatio {
 public:
  explicit ShareRatio(const ShareRatios<Element, R>& ratios) : ratios_(ratios), all_empty_(0.0)
  {
    for (int g = 0; g < Element::n_gauss; ++g) all_empty_ -= min(ratios[g], R(0.0));
  }

  /// left_g of the values at the Gauss points; that of a sub-cell without points is nobody's.
  PerGauss<Element, R> weigh(const PerGauss<Element, R>& values) const
  {
    R empty(0.0);
    PerGauss<Element, R> left;
    for (int g = 0; g < Element::n_gauss; ++g) empty -= min(ratios_[g], R(0.0)) * values[g];
    for (int g = 0; g < Element::n_gauss; ++g) left[g] = max(ratios_[g], R(0.0)) * values[g] + empty;
    return left;
  }
  /// Of points with one share each: left_g over its factor; a sub-cell without points keeps its value.
  void mix(PerGauss<Element, R>& values) const
  {
    const PerGauss<Element, R> left = weigh(values);
    for (int g = 0; g < Element::n_gauss; ++g)
      values[g] = select(ratios_[g] > R(0.0), left[g] / (ratios_[g] + all_empty_), values[g]);
  }

 private:
  ShareRatios<Element, R> ratios_;
  R all_empty_;
};

/// Weights of the Gauss points of a block whose points take strain from their own sub-cell alone: with those of the
/// sub-cells without points, which the others have taken over.
template <class Element>
PerGauss<Element, Pack> weights_taken(const GaussValues<Element, Pack>& gauss)
{
  const Pack zero(0.0), all = total(gauss.volume);
  Pack empty(0.0);
  for (int g = 0; g < Element::n_gauss; ++g) empty += select(gauss.volume[g] > zero, zero, gauss.weight[g]);
  PerGauss<Element, Pack> weight;
  for (int g = 0; g < Element::n_gauss; ++g)
    weight[g] = select(gauss.volume[g] > zero, fma(gauss.volume[g], empty / all, gauss.weight[g]), zero);
  return weight;
}

/// What points divide by which took rows weighed by the ratios. taken: row `ratio` of their patch.
inline Pack inverse_ratio(const SchemeContext& context, Pack taken)
{
  return context.method.strain_shares == StrainShares::transposed ? Pack(1.0) / taken : Pack(1.0);
}

/// Strain that the points of block b take, each from its own sub-cell. room: for it, where a sub-cell has no points.
template <class Element>
const GaussStrain<Element>& handed_back(
    const ShareRatios<Element>& ratios, const GaussStrain<Element>& strain, GaussStrain<Element>& room)
{
  const auto is_empty = [](Real ratio) { return !(ratio > 0.0); };
  if (std::ranges::none_of(ratios, is_empty)) return strain;
  const ShareRatio<Element, Real> ratio(ratios);
  if (&room != &strain) room = strain;
  for (auto& component : room.d_eps) ratio.mix(component);
  ratio.mix(room.d_spin);
  return room;
}

/// The same of the blocks of a layer, one lane per cell.
template <class Element>
const GaussStrain<Element, Pack>& handed_back(const ShareRatios<Element, Pack>& ratios,
    const GaussStrain<Element, Pack>& strain, GaussStrain<Element, Pack>& room)
{
  bool any_empty = false;
  for (const Pack& of_cells : ratios) any_empty |= any_of(!(of_cells > Pack(0.0)));
  if (!any_empty) return strain;
  const ShareRatio<Element, Pack> ratio(ratios);
  if (&room != &strain) room = strain;
  for (auto& component : room.d_eps) ratio.mix(component);
  ratio.mix(room.d_spin);
  return room;
}

}  // namespace terp
