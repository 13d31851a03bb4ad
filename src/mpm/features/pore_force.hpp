// The force of the pore pressure on the soil, of the nodes and of the excess in the soil: one force for both.
// Not for: where the pressures come from (water.hpp, excess.hpp).
#pragma once

#include "mpm/features/excess_pressure.hpp"
#include "mpm/features/water.hpp"
#include "mpm/step/node_passes.hpp"

#include <cmath>

namespace terp {

/// On the corners of the cells of a group [N per m], shape [n].
inline std::span<CornerVectors<Quad4>> water_force(const GroupNow& now)
{
  return now.here(std::span(now.step.work.outer[outer_water].corners));
}

inline void clear_water_force(GroupNow& now)
{
  for (auto& force : water_force(now)) force = {};
}

inline void add_water_forces(Nodes& nodes) { add_outer_forces(nodes, nodes.step.work.outer[outer_water]); }

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

/// Adds the force of the water on the soil of a layer, with weights and operator of its internal force. In cells that
/// the surface cuts the points are pulled where they lie, as they have their weight there: the middle of a sub-cell
/// that holds a thin layer lies above the layer, and its water would lift the node above.
inline void add_water_force(LayerNow& now)
{
  using Element = Quad4;
  constexpr int dim = Element::dim;
  const SchemeContext& context = now.at.step.context;
  const CellGroup<Element>& group = now.at.group;
  const BlockLayer& layer = now.layer;
  const GaussValues<Element, Pack>& gauss = now.gauss;
  const SoilMaterial& material = now.material;
  const std::span<CornerVectors<Element>> of_cells = water_force(now.at);
  std::array<CornerPore<Element>, pack_width> at{};
  bool any = false, any_inside = false;
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
    if (now.at.within[c] == 0.0) {
      const Index cell = group.cells[c];
      add_pull_of_points<Element>(group.mesh.geometry(cell), block,
          pull_at_corners<Element>(*context.pore, group.mesh.cells[cell], material.stores_effective),
          material.is_drained() ? material.density : 0.0, &of_cells[c]);
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
    const Pack excess = gather_excess(now);
    for (Pack& at_gauss : inside) at_gauss -= excess;
  }
  add_pore_force<GeometryLanes<Element>, Element>(
      now.at.geometry, gauss.weight, pore.pressure, inside, context.method.b_bar, sums);
  std::array<CornerVectors<Element>, pack_width> force;
  for (int d = 0; d < dim; ++d) from_lanes(sums[d], [&](int c) { return force[c][d].data(); });
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    for (int d = 0; d < dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) of_cells[c][d][i] += force[c][d][i];
  }
}

}  // namespace terp
