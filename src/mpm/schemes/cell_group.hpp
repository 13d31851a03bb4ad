// Eight neighbouring cells, whose work per cell is done in packs, one lane per cell; the points stay in the blocks of
// each cell (decision 0031). A lane knows nothing of its neighbours: who stands beside whom changes no bit.
#pragma once

#include "mpm/mesh/geometry_lanes.hpp"
#include "mpm/mesh/mesh.hpp"
#include "math/prefetch.hpp"
#include "mpm/schemes/cell_view.hpp"

namespace terp {

/// The blocks of one material and body in the cells of a group.
struct BlockLayer {
  Index material, body;
  std::array<Index, pack_width> block;  ///< by lane; -1: the cell has none
};

/// Numbers by lane, zero where a cell has no block of the layer.
inline Pack where_blocks_are(const BlockLayer& layer, Pack lanes)
{
  alignas(64) Real has[pack_width];
  for (int c = 0; c < pack_width; ++c) has[c] = layer.block[c] >= 0 ? 1.0 : 0.0;
  return select(Pack::load(has) > Pack(0.0), lanes, Pack(0.0));
}

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
  Index next_cell = -1;          ///< first cell of the next group, -1: none
  bool prefetch_points = false;  ///< the points are more than the caches hold

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
    const BlockLayer& layer, const GaussValues<Element, Pack>& gauss, bool b_bar)
{
  constexpr int dim = Element::dim;
  CornerSums<Element, Pack> sums;
  for (auto& direction : sums.internal_force) direction.fill(Pack(0.0));
  add_internal_force(geometry, gauss, b_bar, sums);
  std::array<CornerVectors<Element>, pack_width> force;
  for (int d = 0; d < dim; ++d) from_lanes(sums.internal_force[d], [&](int c) { return force[c][d].data(); });
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    for (int d = 0; d < dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) group.corners[c].internal_force[d][i] += force[c][d][i];
  }
}

/// Strain increments at the Gauss points of a group from displacements of the corners of each cell [m], shape
/// [pack_width].
template <class Element>
inline GaussStrain<Element, Pack> strain_of_group(
    const GeometryLanes<Element>& geometry, const GroupVectors<Element>& du, bool b_bar)
{
  CornerVectors<Element, Pack> lanes;
  for (int d = 0; d < Element::dim; ++d) lanes[d] = to_lanes([&](int c) { return du[c][d].data(); });
  return strain_at_gauss_points(geometry, lanes, b_bar);
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
