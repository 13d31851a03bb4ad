// Cells that a border between soils cuts: the soils slip along it, so that the shear stress on it is the same on both
// sides (docs/methods.md, section 3; decision 0059). Their mean strain stays that of the cell.
//
//   d_eps_m = d_eps + g_m (t n + n t)/2,   sum_m V_m g_m = 0
//   g_m     = (tau - tau_m)/G_m + d_gamma (V/(G_m sum_k V_k/G_k) - 1),   tau = sum_k V_k tau_k/G_k / sum_k V_k/G_k
#pragma once

#include "schemes/block_slip.hpp"
#include "schemes/cell_group.hpp"

#include <algorithm>

namespace terp {

/// Keeps what the slip of the blocks of a layer follows from. gauss: after Eq. (3).
template <class Element>
void keep_mean_stress(const CellGroup<Element>& group, const BlockLayer& layer, const GaussValues<Element, Pack>& gauss)
{
  const Pack weight = total(gauss.weight);
  SymTensor<Pack, 2> mean;
  for (int k = 0; k < n_sym<2>; ++k) mean[k] = weighted_mean(gauss.sigma[k], gauss.weight);
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    BlockSlip& slip = group.slips[layer.block[c]] = {.weight = weight[c]};
    for (int k = 0; k < n_sym<2>; ++k) slip.sigma[k] = mean[k][c];
  }
}

/// Sets the slip of all blocks of a group from their mean stress.
void find_slips(const SchemeContext& context, const CellGroup<Quad4>& group);

/// Direction across the border of two materials in a cell, from the points of both around its centre; zero where they
/// show none.
Vec<2> across_border(const Mesh<2>& mesh, const PointBlocks<2>& points, Index cell, std::array<Index, 2> materials);

/// Slip g of a soil in one step.
template <class Element, class R>
R slip_of(R normal, R shear, R held, R rate, const GaussStrain<Element, R>& strain)
{
  const auto mean = [](const PerGauss<Element, R>& values) { return total(values) * R(1.0 / Element::n_gauss); };
  const R stretch = mean(strain.d_eps[0]) - mean(strain.d_eps[1]), in_plane = mean(strain.d_eps[3]);
  return held + rate * (R(2.0) * (normal * stretch + R(2.0) * shear * in_plane));
}

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

/// Strain of the soil of block b: that of the cell, and what it slips. slipped: room for it where it does.
template <class Element>
const GaussStrain<Element>& with_slip(
    const CellGroup<Element>& group, Index b, const GaussStrain<Element>& strain, GaussStrain<Element>& slipped)
{
  if (group.slips.empty() || !group.slips[b].acts()) return strain;
  const BlockSlip& slip = group.slips[b];
  slipped = strain;
  add_slip(slip.normal, slip.shear, slip_of(slip.normal, slip.shear, slip.held, slip.rate, strain), slipped);
  return slipped;
}

/// The same of the blocks of a layer, one lane per cell.
template <class Element>
const GaussStrain<Element, Pack>& with_slips(const CellGroup<Element>& group, const BlockLayer& layer,
    const GaussStrain<Element, Pack>& strain, GaussStrain<Element, Pack>& slipped)
{
  const auto acts = [&](Index b) { return b >= 0 && group.slips[b].acts(); };
  if (group.slips.empty() || std::ranges::none_of(layer.block, acts)) return strain;
  const auto lanes = [&](Real BlockSlip::*part) {
    return pack_of([&](int c) { return acts(layer.block[c]) ? group.slips[layer.block[c]].*part : 0.0; });
  };
  const Pack normal = lanes(&BlockSlip::normal), shear = lanes(&BlockSlip::shear);
  slipped = strain;
  add_slip(normal, shear, slip_of(normal, shear, lanes(&BlockSlip::held), lanes(&BlockSlip::rate), strain), slipped);
  return slipped;
}

/// What the slip of a block takes from the stress without any work of the nodes [J per m]: it is lost on the border, as
/// the shear stress on both sides was not the same. strain: of the cell.
template <class Element>
Real lost_on_border(const CellGroup<Element>& group, Index b, const GaussStrain<Element>& strain)
{
  if (group.slips.empty() || !group.slips[b].acts()) return 0.0;
  const BlockSlip& slip = group.slips[b];
  const Real tau = slip.normal * (slip.sigma[0] - slip.sigma[1]) + 2.0 * slip.shear * slip.sigma[3];
  return -slip.weight * tau * slip_of(slip.normal, slip.shear, slip.held, slip.rate, strain);
}

/// The same of all blocks of a group.
template <class Element>
Real lost_on_borders(const CellGroup<Element>& group, const GaussStrain<Element, Pack>& strain)
{
  if (group.slips.empty()) return 0.0;
  const auto of_cells = strain_by_cell(strain);
  Real lost = 0.0;
  for (int c = 0; c < group.n(); ++c)
    for_each_block(
        group.points, group.cells[c], [&](const auto&, Index b) { lost += lost_on_border(group, b, of_cells[c]); });
  return lost;
}

}  // namespace terp
