// Points to Gauss points to corners for the schemes that integrate at Gauss points: internal force and force of the
// water of a group of cells. Not for: what a scheme keeps of it.
#pragma once

#include "mpm/schemes/cut_cells.hpp"
#include "mpm/schemes/excess_pressure.hpp"
#include "mpm/schemes/pressure_balance.hpp"

#include <cmath>

namespace terp {

/// A quantity of the nodes where the points of each sub-cell lie in the mean, as Eq. (1) has their stress. With shares
/// that overlap: in the middle of the sub-cell.
template <class Element>
inline PerGauss<Element, Pack> at_points_of_sub_cells(const SchemeContext& context, const CellGroup<Element>& group,
    const BlockLayer& layer, const GaussValues<Element, Pack>& gauss, const PerCorner<Element, Pack>& corners)
{
  constexpr int dim = Element::dim;
  PerDirection<Element, PerGauss<Element, Pack>> places;
  for (int d = 0; d < dim; ++d) {
    if (context.inverse_extent < 0) {
      const SubCellMeans mean(gauss);
      places[d] = sum_row(group, layer, PointRows<dim>::xi + d);
      mean(places[d]);
    } else {
      for (int g = 0; g < Element::n_gauss; ++g) places[d][g] = Pack(std::copysign(0.5, Element::gauss_place(g)[d]));
    }
  }
  PerGauss<Element, Pack> values;
  for (int g = 0; g < Element::n_gauss; ++g) {
    PerDirection<Element, Pack> place;
    for (int d = 0; d < dim; ++d) place[d] = places[d][g];
    const auto N = Element::shape_functions(place);
    values[g] = N[0] * corners[0];
    for (int i = 1; i < Element::n_corners; ++i) values[g] = fma(N[i], corners[i], values[g]);
  }
  return values;
}

/// Adds the force of the excess pressure that soil of a layer stores, -u I as part of its stress.
template <class Element>
inline void add_stored_excess_force(const SchemeContext& context, const CellGroup<Element>& group,
    const GeometryLanes<Element>& geometry, const BlockLayer& layer, const GaussValues<Element, Pack>& gauss)
{
  GaussValues<Element, Pack> water{.sigma = {}, .volume = gauss.volume, .weight = gauss.weight, .pressure = {}};
  const Pack excess = gather_excess(context, group, layer, gauss);
  for (int k = 0; k < n_sym<Element::dim>; ++k) water.sigma[k].fill(k < 3 ? Pack(0.0) - excess : Pack(0.0));
  add_internal_force(group, geometry, layer, water, context.method.b_bar);
}

/// Adds the force of the water on the soil of a layer, with weights and operator of its internal force. In cells that
/// the surface cuts the points are pulled where they lie, as they have their weight there: the middle of a sub-cell
/// that holds a thin layer lies above the layer, and its water would lift the node above. within: as is_within_soil.
template <class Element>
inline void add_water_force(const SchemeContext& context, const CellGroup<Element>& group,
    const GeometryLanes<Element>& geometry, const BlockLayer& layer, const GaussValues<Element, Pack>& gauss,
    Pack within)
{
  constexpr int dim = Element::dim;
  std::array<CornerPore<Element>, pack_width> at{};
  bool any = false, any_inside = false;
  const SoilMaterial& material = context.materials[layer.material];
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0 || context.pore == nullptr) continue;
    at[c] = pore_at_corners<Element>(*context.pore, group.mesh.cells[group.cells[c]], material.stores_effective);
    for (int i = 0; i < Element::n_corners; ++i) {
      any |= at[c].pressure[i] != 0.0;
      any_inside |= at[c].inside[i] != 0.0;
    }
  }
  const bool has_excess = material.excess_row >= 0 && !stores_excess(context, material);
  if (!any && !any_inside && !has_excess) return;
  for (int c = 0; any && c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    const PointBlock<dim>& block = group.points.block(layer.block[c]);
    if (within[c] == 0.0) {
      const Index cell = group.cells[c];
      add_pull_of_points<Element>(group.mesh.geometry(cell), block,
          pull_at_corners<Element>(*context.pore, group.mesh.cells[cell], material.stores_effective),
          material.is_drained() ? material.density : 0.0, &group.water_force[c]);
      at[c].pressure = {};
    } else if (material.is_drained()) {
      const Real share = first_volume_over_present(block, material.density);
      for (Real& pressure : at[c].pressure) pressure *= share;
    }
  }
  CornerPore<Element, Pack> pore;
  pore.pressure = to_lanes([&](int c) { return at[c].pressure.data(); });
  pore.inside = to_lanes([&](int c) { return at[c].inside.data(); });
  CornerVectors<Element, Pack> sums;
  for (auto& direction : sums) direction.fill(Pack(0.0));
  auto inside =
      any_inside ? at_points_of_sub_cells(context, group, layer, gauss, pore.inside) : zero_packs<Element::n_gauss>();
  if (has_excess) {
    const Pack excess = gather_excess(context, group, layer, gauss);
    for (Pack& at_gauss : inside) at_gauss -= excess;
  }
  add_pore_force<GeometryLanes<Element>, Element>(
      geometry, gauss.weight, pore.pressure, inside, context.method.b_bar, sums);
  std::array<CornerVectors<Element>, pack_width> force;
  for (int d = 0; d < dim; ++d) from_lanes(sums[d], [&](int c) { return force[c][d].data(); });
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    for (int d = 0; d < dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) group.water_force[c][d][i] += force[c][d][i];
  }
}

/// Gauss values, weights, smooth pressure and internal force of the cells of a group for the schemes that integrate at
/// Gauss points. gauss_of(layer): where those of a layer are; sum(layer, gauss): their sums; finish(layer, gauss):
/// what the scheme does before the force.
template <class Element, class GaussOf, class Sum, class Finish>
void gather_at_gauss_points(
    const SchemeContext& context, const CellGroup<Element>& group, GaussOf&& gauss_of, Sum&& sum, Finish&& finish)
{
  PerGauss<Element, Pack> cell_volume = zero_packs<Element::n_gauss>();
  for_each_layer(group, [&](const BlockLayer& layer) {
    GaussValues<Element, Pack>& gauss = gauss_of(layer);
    sum(layer, gauss);
    for (int g = 0; g < Element::n_gauss; ++g) cell_volume[g] += gauss.volume[g];
  });
  GeometryLanes<Element> geometry = geometry_of(group);
  Pack within(1.0);
  if (!group.volume_gradients.empty() || !group.balance.empty())
    within = is_within_soil(group, filled_share(geometry, total(cell_volume), context.method));
  if (!group.volume_gradients.empty())
    set_volume_gradient(
        group, within, [&](const BlockLayer& layer) { return gauss_of(layer).volume; }, geometry);
  for (CellBalance& of_cell : group.balance) of_cell = {};
  for (auto& force : group.balance_force) force = {};
  for_each_layer(group, [&](const BlockLayer& layer) {
    GaussValues<Element, Pack>& gauss = gauss_of(layer);
    set_weights(geometry, cell_volume, context.method, gauss);  // R3
    if (!group.ratios.empty()) keep_ratios(group, layer, gauss);
    divide_by_volume(gauss);  // Eq. (1)
    smooth_pressure(gauss);   // Eqs. (2), (3)
    if (!group.slips.empty()) keep_mean_stress(group, layer, gauss);
    finish(layer, gauss);
    add_internal_force(group, geometry, layer, gauss, context.method.b_bar);  // Eq. (4)
    if (!group.balance.empty()) add_balance(context, group, geometry, layer, gauss, within);
    if (group.water_force.empty()) return;
    add_water_force(context, group, geometry, layer, gauss, within);
    const SoilMaterial& material = context.materials[layer.material];
    if (material.excess_row >= 0 && stores_excess(context, material))
      add_stored_excess_force(context, group, geometry, layer, gauss);
  });
  if (!group.slips.empty()) find_slips(context, group);
}

}  // namespace terp
