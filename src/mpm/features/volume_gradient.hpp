// Where a cell's volume change is taken: B-bar has one for all Gauss points of a cell (reading R5). Within the soil it
// is that of the centre, which is the mean over the cell. In a cell that the surface cuts it is the mean over the soil
// there, with the weights that its blocks have in the force (decision 0067):
//
//   grad N_i  =  sum_b W_b (sum_p Omega_p grad N_i(x_p) / sum_p Omega_p) / sum_b W_b,    W_b = sum_g Omega_g
//
// Force and strain take the same gradients, so one stays the transpose of the other.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "mpm/kernels/point_gradients.hpp"
#include "mpm/step/now.hpp"

namespace terp {

/// The soil ends in a cell that it does not fill: a cell around one of its corners holds none, or the mesh ends. Across
/// the corner that lies farthest out no soil lies beyond a plane surface. Gaps between points elsewhere are not the
/// surface: taken for it, clay of 2 x 2 points flowed with 1.4 times the work of gravity (decision 0067).
template <class Element>
bool is_at_surface(const CellGroup<Element>& group, Index cell)
{
  const auto& mesh = group.mesh;
  for (const Index other : mesh.neighbours[cell])
    if (other == outside) return true;
  for (const Index node : mesh.cells[cell])
    for (Index k = mesh.first_cell_of_node[node]; k < mesh.first_cell_of_node[node + 1]; ++k)
      if (group.points.slot_of_cell()[mesh.cells_of_node[k].cell] < 0) return true;
  return false;
}

/// 1 in lanes whose cell the surface does not cut, else 0. filled: 1 where the weights are those of a filled cell.
template <class Element>
Pack is_within_soil(const CellGroup<Element>& group, Pack filled)
{
  alignas(64) Real within[pack_width];
  filled.store(within);
  for (int c = 0; c < group.n(); ++c)
    if (within[c] == 0.0 && !is_at_surface(group, group.cells[c])) within[c] = 1.0;
  return Pack::load(within);
}

inline void find_surface(GroupNow& now)
{
  now.within = is_within_soil(now.group, filled_share(now.geometry, total(now.volume), now.step.model.method));
}

/// Adds the mean of the gradients over the points of a block, times `weight`.
template <class Element>
void add_mean_gradient(const CellGeometry<Element>& cell, const PointBlock<Element::dim>& block, Real weight,
    PerCorner<Element, Vec<Element::dim>>& gradients)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  auto sums = zero_packs<dim, Element::n_corners>();
  Pack volume(0.0);
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto gradient = gradients_at(cell, load_rows<dim>(block, Rows::xi, p));
    const Pack omega = Pack::load(block.row(Rows::volume) + p);
    volume += omega;
    for (int i = 0; i < Element::n_corners; ++i)
      for (int d = 0; d < dim; ++d) sums[d][i] = fma(omega, gradient[i][d], sums[d][i]);
  }
  const Real part = weight / sum(volume);
  for (int d = 0; d < dim; ++d) {
    const auto each = sum_each(sums[d]);
    for (int i = 0; i < Element::n_corners; ++i) gradients[i][d] += part * each[i];
  }
}

/// Sets the gradients of a group in its geometry, and keeps them for the strain. within: as is_within_soil.
/// volume_of(layer): W_g of its blocks, one lane per cell, shape [g].
template <class Element, class VolumeOf>
void set_volume_gradient(const CellGroup<Element>& group, Pack within, VolumeOf&& volume_of,
    GeometryLanes<Element>& geometry, VolumeGradient<Element>& kept)
{
  std::array<PerCorner<Element, Vec<Element::dim>>, pack_width> sums{};
  std::array<Real, pack_width> weights{};
  bool any = false;
  for (int c = 0; c < group.n(); ++c) any |= within[c] == 0.0;
  if (any) {
    for_each_layer(group, [&](const BlockLayer& layer) {
      const Pack weight = total(volume_of(layer));
      for (int c = 0; c < group.n(); ++c) {
        if (layer.block[c] < 0 || within[c] != 0.0) continue;
        weights[c] += weight[c];
        add_mean_gradient(group.mesh.geometry(group.cells[c]), group.points.block(layer.block[c]), weight[c], sums[c]);
      }
    });
    for (int i = 0; i < Element::n_corners; ++i)
      for (int d = 0; d < Element::dim; ++d) {
        const Pack centre = geometry.centre_gradient[i][d];
        geometry.centre_gradient[i][d] =
            pack_of([&](int c) { return weights[c] > 0.0 ? sums[c][i][d] / weights[c] : centre[c]; });
      }
  }
  kept = geometry.centre_gradient;
}

}  // namespace terp
