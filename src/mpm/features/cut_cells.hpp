// Cells that a border between soils cuts: where a soil yielded in the step before, the soils slip along it, so that the
// shear stress on it is the same on both sides, and the corners move with them, k by soil a (docs/methods.md, section
// 3; decision 0071).
//
//   d_eps_m = B (du_i - k s_i t) + g_m (t n + n t)/2
//   g_m     = (tau - tau_m)/G_m + k c_a,   tau = sum_k V_k tau_k/G_k / sum_k V_k/G_k
#pragma once

#include "mpm/features/block_slip.hpp"
#include "mpm/schemes/cell_group.hpp"
#include "mpm/features/soil_border.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

/// Keeps what the slip of the blocks of a layer follows from. gauss: after Eq. (3).
template <class Element>
void keep_mean_stress(std::span<BlockSlip> slips, const BlockLayer& layer, const GaussValues<Element, Pack>& gauss)
{
  const Pack weight = total(gauss.weight);
  SymTensor<Pack, 2> mean;
  for (int k = 0; k < n_sym<2>; ++k) mean[k] = weighted_mean(gauss.sigma[k], gauss.weight);
  for (int c = 0; c < pack_width; ++c) {
    if (layer.block[c] < 0) continue;
    BlockSlip& slip = slips[layer.block[c]] = {.weight = weight[c]};
    for (int k = 0; k < n_sym<2>; ++k) slip.sigma[k] = mean[k][c];
  }
}

/// Sets the slip of all blocks of a group, but for the kink, from their mean stress.
void find_slips(const SchemeContext& context, const CellGroup<Quad4>& group, std::span<BlockSlip> slips);

/// Adds the strain of a slip to that of the cell, at all Gauss points.
template <class Element, class R>
void add_slip(R normal, R shear, R g, GaussStrain<Element, R>& strain)
{
  for (int k = 0; k < Element::n_gauss; ++k) {
    strain.d_eps[0][k] += g * normal;
    strain.d_eps[1][k] -= g * normal;
    strain.d_eps[3][k] += g * shear;
    strain.d_spin[k] -= R(0.5) * g;
  }
}

/// The kink that a cell takes: what slipped in the step before, but no more than what would move the corners as they
/// move now, and none when they go back. across: the shear of the cell that a kink of 1 makes.
inline Real kink_of(const Kink& kink, Real d_gamma, Real across)
{
  const Real most = d_gamma / std::max(across, 1e-6);
  return std::clamp(kink.slipped, std::min(most, 0.0), std::max(most, 0.0));
}

/// Displacements of the corners less what the soils of the cut cells slipped past each other, for the strain that both
/// sides of the border have; adds them to the slip of the soils. The work of the corners with the rest is booked as
/// lost on the border. moved: room for them where there are such cells.
template <class Element>
const GroupVectors<Element>& without_kinks(const CellGroup<Element>& group, std::span<BlockSlip> slips,
    const GroupVectors<Element>& du, GroupVectors<Element>& moved, Real& lost)
{
  const auto kink_at = [&](int c) -> const Kink& { return slips[group.points.first_block(group.cells[c])].kink; };
  bool any = false;
  for (int c = 0; c < group.n(); ++c) any |= kink_at(c).slipped != 0.0;
  if (!any) return du;
  moved = du;
  for (int c = 0; c < group.n(); ++c) {
    const Kink& kink = kink_at(c);
    if (kink.slipped == 0.0) continue;
    const Vec<2> t = kink.along, n{-t[1], t[0]};
    Real d_gamma = 0.0, across = 0.0;
    for (int i = 0; i < Element::n_corners; ++i) {
      const auto& gradient = group.mesh.geometry(group.cells[c]).centre_gradient[i];
      const Real of_n = gradient[0] * n[0] + gradient[1] * n[1], of_t = gradient[0] * t[0] + gradient[1] * t[1];
      d_gamma += of_n * (t[0] * du[c][0][i] + t[1] * du[c][1][i]) + of_t * (n[0] * du[c][0][i] + n[1] * du[c][1][i]);
      across += of_n * kink.above[i];
    }
    const Real k = kink_of(kink, d_gamma, across);
    for (int d = 0; d < Element::dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) moved[c][d][i] -= k * kink.above[i] * t[d];
    lost += k * kink.force;
    for_each_block(group.points, group.cells[c], [&](const auto&, Index b) { slips[b].g += k * kink.share; });
  }
  return moved;
}

/// Strain of the soil of block b: that of the cell, and what it slips. slipped: room for it where it does.
template <class Element>
const GaussStrain<Element>& with_slip(
    std::span<const BlockSlip> slips, Index b, const GaussStrain<Element>& strain, GaussStrain<Element>& slipped)
{
  const BlockSlip& slip = slips[b];
  if (!slip.acts()) return strain;
  slipped = strain;
  add_slip(slip.normal, slip.shear, slip.g, slipped);
  return slipped;
}

/// The same of the blocks of a layer, one lane per cell.
template <class Element>
const GaussStrain<Element, Pack>& with_slips(std::span<const BlockSlip> slips, const BlockLayer& layer,
    const GaussStrain<Element, Pack>& strain, GaussStrain<Element, Pack>& slipped)
{
  const auto acts = [&](Index b) { return b >= 0 && slips[b].acts(); };
  if (std::ranges::none_of(layer.block, acts)) return strain;
  const auto lanes = [&](Real BlockSlip::*part) {
    return pack_of([&](int c) { return acts(layer.block[c]) ? slips[layer.block[c]].*part : 0.0; });
  };
  slipped = strain;
  add_slip(lanes(&BlockSlip::normal), lanes(&BlockSlip::shear), lanes(&BlockSlip::g), slipped);
  return slipped;
}

/// Mean shear stress of the points of a block on its border [Pa].
template <int Dim>
Real shear_on_border(const PointBlock<Dim>& block, const BlockSlip& slip)
{
  Pack sum_of_tau(0.0), volume(0.0);
  for (Index p = 0; p < block.n; p += pack_width) {
    const SymTensor<Pack, Dim> sigma = stress_of(block, p);
    const Mask in_use = lane_numbers() < Pack(static_cast<Real>(block.n - p));
    const Pack omega = select(in_use, Pack::load(block.row(PointRows<Dim>::volume) + p), Pack(0.0));
    const Pack tau = Pack(slip.normal) * (sigma[0] - sigma[1]) + Pack(2.0 * slip.shear) * sigma[3];
    sum_of_tau += omega * tau;
    volume += omega;
  }
  return sum(sum_of_tau) / sum(volume);
}

/// What the slip of all blocks of a group takes from the stress of the start without any work of the nodes [J per m]:
/// it is lost on the border, as the shear stress on both sides was not the same. Before the law runs.
template <class Element>
Real lost_by_slipping(const CellGroup<Element>& group, std::span<BlockSlip> slips)
{
  Real lost = 0.0;
  for (int c = 0; c < group.n(); ++c)
    for_each_block(group.points, group.cells[c], [&](const auto& block, Index b) {
      BlockSlip& slip = slips[b];
      if (!slip.acts()) return;
      slip.before = shear_on_border(block, slip);
      const Real tau = slip.normal * (slip.sigma[0] - slip.sigma[1]) + 2.0 * slip.shear * slip.sigma[3];
      lost -= slip.weight * tau * slip.g;
    });
  return lost;
}

/// The same of the half of what the law changed in the stress of a block since then: the stress of a step is the mean
/// of its start and its end.
template <int Dim>
Real lost_while_slipping(const PointBlock<Dim>& block, const BlockSlip& slip)
{
  return slip.acts() ? -0.5 * slip.weight * (shear_on_border(block, slip) - slip.before) * slip.g : 0.0;
}

}  // namespace terp
