// Eight neighbouring cells, whose work per cell is done in packs, one lane per cell; the points stay in the blocks of
// each cell (decision 0031). A lane knows nothing of its neighbours: who stands beside whom changes no bit.
#pragma once

#include "mesh/geometry_lanes.hpp"
#include "mesh/mesh.hpp"
#include "parallel/prefetch.hpp"
#include "schemes/cell_view.hpp"

#include <cmath>

namespace terp {

/// The blocks of one material and body in the cells of a group.
struct BlockLayer {
  Index material, body;
  std::array<Index, pack_width> block;  ///< by lane; -1: the cell has none
};

struct PatchValues;

/// Up to eight neighbouring occupied cells.
template <class Element>
struct CellGroup {
  std::span<const Index> cells;  ///< shape [n], n at most pack_width
  const Mesh<Element::dim>& mesh;
  PointBlocks<Element::dim>& points;
  std::span<CornerSums<Element>> corners;  ///< shape [n]
  std::span<Real> pressure;  ///< p_e [Pa], by block number; of schemes that need no more from gather to update_stress
  std::span<GaussValues<Element, Pack>>
      gauss;  ///< shape [n_materials, n_bodies, n_groups]; of schemes that keep them from gather to update_stress
  std::span<GaussRow<Element>> gauss_rows =
      {};                  ///< shape [n_materials, n_bodies, n_groups, n_gauss_rows]; of schemes whose law runs there
  Index n_gauss_rows = 0;  ///< the most that any law adds to the points
  Index number = 0, n_groups = 1;
  Index next_cell = -1;                                ///< first cell of the next group, -1: none
  bool prefetch_points = false;                        ///< the points are more than the caches hold
  PatchValues* patches = nullptr;                      ///< of shares that overlap (patch_group.hpp)
  std::span<CornerVectors<Element>> water_force = {};  ///< on the corners [N per m], shape [n]; empty: no water

  int n() const { return static_cast<int>(cells.size()); }
  CellView<Element> cell(int c) const { return {cells[c], mesh.geometry(cells[c]), points, corners[c]}; }
  GaussValues<Element, Pack>& gauss_of(const BlockLayer& layer) const { return gauss[place_of(layer)]; }
  GaussRow<Element>* rows_of(const BlockLayer& layer) const
  {
    return gauss_rows.data() + place_of(layer) * n_gauss_rows;
  }

 private:
  std::ptrdiff_t place_of(const BlockLayer& layer) const
  {
    return (std::ptrdiff_t{layer.material} * points.n_bodies() + layer.body) * n_groups + number;
  }
};

/// A vector at each corner of each cell of a group, shape [cell][d][corner].
template <class Element>
using GroupVectors = std::array<CornerVectors<Element>, pack_width>;

/// Fetches rows `first` to `end` - 1 of the points of the cell after cell c while those of c are worked on: the
/// processor does not see by itself that one block follows another.
template <class Element>
inline void prefetch_next(const CellGroup<Element>& group, int c, int first, int end)
{
  const Index next = c + 1 < group.n() ? group.cells[c + 1] : group.next_cell;
  if (!group.prefetch_points || next < 0) return;
  for_each_block(group.points, next, [&](const auto& block, Index) {
    prefetch(block.row(first), static_cast<std::ptrdiff_t>(end - first) * block.capacity);
  });
}

/// The same for the stress pass, which needs almost all rows.
template <class Element>
inline void prefetch_next(const CellGroup<Element>& group, int c)
{
  prefetch_next(group, c, 0, group.points.n_rows());
}

/// Geometry of the cells of a group; lanes beyond the last repeat the first.
template <class Element>
inline GeometryLanes<Element> geometry_of(const CellGroup<Element>& group)
{
  std::array<const CellGeometry<Element>*, pack_width> cells;
  for (int c = 0; c < pack_width; ++c) cells[c] = &group.mesh.geometry(group.cells[c < group.n() ? c : 0]);
  return geometry_lanes(cells);
}

/// Calls f(layer) for each material and body in a group, in the order of block keys.
template <class Element, class F>
void for_each_layer(const CellGroup<Element>& group, F&& f)
{
  std::array<Index, pack_width> next;
  for (int c = 0; c < pack_width; ++c) next[c] = c < group.n() ? group.points.first_block(group.cells[c]) : -1;
  for (;;) {
    const PointBlock<Element::dim>* first = nullptr;
    const auto key_of = [](const auto& block) { return std::pair(block.material, block.body); };
    for (const Index b : next)
      if (b >= 0 && (first == nullptr || key_of(group.points.block(b)) < key_of(*first)))
        first = &group.points.block(b);
    if (first == nullptr) return;
    BlockLayer layer{first->material, first->body, {}};
    for (int c = 0; c < pack_width; ++c) {
      const bool here = next[c] >= 0 && key_of(group.points.block(next[c])) == key_of(*first);
      layer.block[c] = here ? next[c] : -1;
      if (here) next[c] = group.points.block(next[c]).next;
    }
    f(layer);
  }
}

template <class Element>
inline bool has_one_layer(const CellGroup<Element>& group)
{
  int n = 0;
  for_each_layer(group, [&](const BlockLayer&) { ++n; });
  return n == 1;
}

/// Sub-cell sums of the blocks of a layer, one lane per cell; zero where there is no block.
template <class Element>
inline void sum_layer(const CellGroup<Element>& group, const BlockLayer& layer, GaussValues<Element, Pack>& gauss)
{
  std::array<GaussValues<Element>, pack_width> sums;
  for (int c = 0; c < pack_width; ++c) {
    if (layer.block[c] >= 0)
      sum_over_sub_cells(group.points.block(layer.block[c]), sums[c]);
    else
      sums[c] = {};
  }
  gauss.volume = to_lanes([&](int c) { return sums[c].volume.data(); });
  for (int k = 0; k < n_sym<Element::dim>; ++k)
    gauss.sigma[k] = to_lanes([&](int c) { return sums[c].sigma[k].data(); });
}

/// The same of one row.
template <class Element>
inline GaussRow<Element> sum_row(const CellGroup<Element>& group, const BlockLayer& layer, int row)
{
  std::array<PerGauss<Element>, pack_width> sums{};
  for (int c = 0; c < pack_width; ++c)
    if (layer.block[c] >= 0) sums[c] = sum_row_over_sub_cells<Element>(group.points.block(layer.block[c]), row);
  return to_lanes([&](int c) { return sums[c].data(); });
}

/// Adds the internal force of the Gauss values of a layer to the corners of its cells, Eq. (4).
template <class Element>
inline void add_internal_force(const CellGroup<Element>& group, const GeometryLanes<Element>& geometry,
    const BlockLayer& layer, const GaussValues<Element, Pack>& gauss, ForceOperator op)
{
  constexpr int dim = Element::dim;
  CornerSums<Element, Pack> sums;
  for (auto& direction : sums.internal_force) direction.fill(Pack(0.0));
  add_internal_force(geometry, gauss, op, sums);
  std::array<CornerVectors<Element>, pack_width> force;
  for (int d = 0; d < dim; ++d) from_lanes(sums.internal_force[d], [&](int c) { return force[c][d].data(); });
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    for (int d = 0; d < dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) group.corners[c].internal_force[d][i] += force[c][d][i];
  }
}

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

/// Adds the force of the water on the soil of a layer, with weights and operator of its internal force.
template <class Element>
inline void add_water_force(const SchemeContext& context, const CellGroup<Element>& group,
    const GeometryLanes<Element>& geometry, const BlockLayer& layer, const GaussValues<Element, Pack>& gauss)
{
  constexpr int dim = Element::dim;
  std::array<CornerPore<Element>, pack_width> at{};
  bool any = false, any_inside = false;
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    at[c] = pore_at_corners<Element>(
        *context.pore, group.mesh.cells[group.cells[c]], context.materials[layer.material].drained);
    for (int i = 0; i < Element::n_corners; ++i) {
      any |= at[c].pressure[i] != 0.0;
      any_inside |= at[c].inside[i] != 0.0;
    }
  }
  if (!any && !any_inside) return;
  CornerPore<Element, Pack> pore;
  pore.pressure = to_lanes([&](int c) { return at[c].pressure.data(); });
  pore.inside = to_lanes([&](int c) { return at[c].inside.data(); });
  CornerVectors<Element, Pack> sums;
  for (auto& direction : sums) direction.fill(Pack(0.0));
  const auto inside =
      any_inside ? at_points_of_sub_cells(context, group, layer, gauss, pore.inside) : zero_packs<Element::n_gauss>();
  add_pore_force<GeometryLanes<Element>, Element>(
      geometry, gauss.weight, pore.pressure, inside, context.method.force_operator, sums);
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
  const GeometryLanes<Element> geometry = geometry_of(group);
  for_each_layer(group, [&](const BlockLayer& layer) {
    GaussValues<Element, Pack>& gauss = gauss_of(layer);
    set_weights(geometry, cell_volume, context.method, gauss);  // R3
    divide_by_volume(gauss);                                    // Eq. (1)
    smooth_pressure(gauss);                                     // Eqs. (2), (3)
    finish(layer, gauss);
    add_internal_force(group, geometry, layer, gauss, context.method.force_operator);  // Eq. (4)
    if (context.pore != nullptr) add_water_force(context, group, geometry, layer, gauss);
  });
}

/// Strain increments at the Gauss points of a group from displacements of the corners of each cell [m], shape
/// [pack_width].
template <class Element>
inline GaussStrain<Element, Pack> strain_of_group(
    const CellGroup<Element>& group, const GroupVectors<Element>& du, bool b_bar)
{
  CornerVectors<Element, Pack> lanes;
  for (int d = 0; d < Element::dim; ++d) lanes[d] = to_lanes([&](int c) { return du[c][d].data(); });
  return strain_at_gauss_points(geometry_of(group), lanes, b_bar);
}

/// Strain increments cell by cell.
template <class Element>
inline std::array<GaussStrain<Element>, pack_width> strain_by_cell(const GaussStrain<Element, Pack>& lanes)
{
  std::array<GaussStrain<Element>, pack_width> strain;
  for (int k = 0; k < n_sym<Element::dim>; ++k)
    from_lanes(lanes.d_eps[k], [&](int c) { return strain[c].d_eps[k].data(); });
  from_lanes(lanes.d_spin, [&](int c) { return strain[c].d_spin.data(); });
  return strain;
}

}  // namespace terp
