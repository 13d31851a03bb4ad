// The slope of the isotropic stress within a block, beside the one number p_e of Eq. (2) (`method.pressure =
// "balanced"`; docs/methods.md, section 3; decision 0068). After Eq. (4), per block:
//
//   f_int,i += sum_g Omega_g grad N_i(xi_g) G.(x_g - mean x),   G = rho (a_K - g) + r grad p_w
//
// rho is the density of its points, a_K the acceleration of the cell in this step, grad p_w that of the water which
// pulls at the soil. The sum is linear in G. So a cell keeps the matrices k_i = sum_g Omega_g grad N_i (x_g - mean x)^T
// of its blocks, times rho, and the nodes find a_K and the force with them (mpm/features/balance_passes.hpp). Where the
// surface cuts the cell, the points take the place of the Gauss points, as they do for the volume change. Soil whose
// strength follows the pressure takes part in those cells alone: elsewhere the layers that fail would stand by a
// pressure that their law does not see.
//
// Where several soils share the cell, mean x is that of all of them, and what Eq. (4) has of that is taken off: the
// pressures of its blocks differ by G from place to place, but have one gradient grad N_i(0) there.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "mpm/kernels/cell_balance.hpp"
#include "mpm/features/volume_gradient.hpp"

namespace terp {

using BlockMoment = PerCorner<Quad4, CellBalance::Matrix>;

/// Volume of points and their mean place, from the middle of their cell.
struct SoilPlace {
  Real volume = 0.0;
  Vec<2> mean{0.0, 0.0};

  template <class Element>
  void add(const CellGeometry<Element>& cell, const PointBlock<2>& block)
  {
    Vec<2> sums{0.0, 0.0};
    Real added = 0.0;
    for (Index p = 0; p < block.n; p += pack_width) {
      const Pack omega = Pack::load(block.row(Rows::volume) + p);
      const auto x = Element::offset_from_centre(cell.map, load_rows<2>(block, Rows::xi, p));
      added += sum(omega);
      for (int d = 0; d < 2; ++d) sums[d] += sum(omega * x[d]);
    }
    for (int d = 0; d < 2; ++d) mean[d] = (mean[d] * volume + sums[d]) / (volume + added);
    volume += added;
  }
};

/// k_i of a block from its points [m^2]. about: mean place of all soil of the cell, from which the pressures of its
/// blocks differ by G; the force has taken them with `volume_gradient`, the one gradient of the cell.
template <class Element>
BlockMoment moment_of_points(const CellGeometry<Element>& cell, const PointBlock<2>& block, Real weight,
    const Vec<2>& about, const PerCorner<Element, Vec<2>>& volume_gradient)
{
  SoilPlace own;
  own.add(cell, block);
  BlockMoment k{};
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto local = load_rows<2>(block, Rows::xi, p);
    const auto x = Element::offset_from_centre(cell.map, local);
    const auto gradient = gradients_at(cell, local);
    const Pack w = Pack::load(block.row(Rows::volume) + p) * Pack(weight / own.volume);
    for (int e = 0; e < 2; ++e) {
      const Pack arm = w * (x[e] - Pack(about[e]));
      for (int i = 0; i < 4; ++i)
        for (int d = 0; d < 2; ++d) k[i][d][e] += sum(gradient[i][d] * arm);
    }
  }
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < 2; ++d)
      for (int e = 0; e < 2; ++e) k[i][d][e] -= weight * volume_gradient[i][d] * (own.mean[e] - about[e]);
  return k;
}

/// k_i of the blocks of a layer from the Gauss points, one lane per cell, shape [corner][d][e].
template <class Element>
PerCorner<Element, std::array<std::array<Pack, 2>, 2>> moment_of_gauss_points(
    const CellGroup<Element>& group, const GeometryLanes<Element>& geometry, const PerGauss<Element, Pack>& weight)
{
  std::array<PerGauss<Element, Pack>, 2> arm;
  std::array<typename Element::Map, pack_width> map;
  for (int c = 0; c < pack_width; ++c) map[c] = group.mesh.geometry(group.cells[c < group.n() ? c : 0]).map;
  const Pack inverse = Pack(1.0) / total(weight);
  for (int e = 0; e < 2; ++e) {
    const Pack xi = pack_of([&](int c) { return map[c].axis_xi[e]; }),
               eta = pack_of([&](int c) { return map[c].axis_eta[e]; }),
               twist = pack_of([&](int c) { return map[c].twist[e]; });
    for (int g = 0; g < Element::n_gauss; ++g) {
      const auto [s, t] = Element::gauss_place(g);
      arm[e][g] = xi * Pack(s) + eta * Pack(t) + twist * Pack(s * t);
    }
    const Pack mean = sum_in_pairs<Element::n_gauss>([&](std::size_t g) { return weight[g] * arm[e][g]; }) * inverse;
    for (int g = 0; g < Element::n_gauss; ++g) arm[e][g] = weight[g] * (arm[e][g] - mean);
  }
  PerCorner<Element, std::array<std::array<Pack, 2>, 2>> k;
  for (int i = 0; i < Element::n_corners; ++i)
    for (int d = 0; d < 2; ++d)
      for (int e = 0; e < 2; ++e)
        k[i][d][e] =
            sum_in_pairs<Element::n_gauss>([&](std::size_t g) { return geometry.gradient[i][d][g] * arm[e][g]; });
  return k;
}

/// Mass and volume of the points of a block.
struct BlockMass {
  Real mass = 0.0, volume = 0.0;
  explicit BlockMass(const PointBlock<2>& block)
  {
    Pack m(0.0), v(0.0);
    for (Index p = 0; p < block.n; p += pack_width) {
      m += Pack::load(block.row(Rows::mass) + p);
      v += Pack::load(block.row(Rows::volume) + p);
    }
    mass = sum(m);
    volume = sum(v);
  }
};

/// Adds what the blocks of a layer have in their cells' balance. within: as is_within_soil; balance, forces: of the
/// cells, shape [n]; forces: empty where nothing but weight and acceleration has a part in the slope.
template <class Element>
void add_balance(const SchemeContext& context, const CellGroup<Element>& group, const GeometryLanes<Element>& geometry,
    const BlockLayer& layer, const GaussValues<Element, Pack>& gauss, Pack within, std::span<CellBalance> balance,
    std::span<CornerVectors<Element>> forces)
{
  const SoilMaterial& material = context.materials[layer.material];
  const bool everywhere = material.ignores_pressure;
  std::array<std::array<Real, 16>, pack_width> full;
  if (everywhere) {
    const auto k = moment_of_gauss_points(group, geometry, gauss.weight);
    for (int i = 0; i < 4; ++i)
      from_lanes(std::array{k[i][0][0], k[i][0][1], k[i][1][0], k[i][1][1]}, [&](int c) { return &full[c][4 * i]; });
  }
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0 || (!everywhere && within[c] != 0.0)) continue;
    const PointBlock<2>& block = group.points.block(layer.block[c]);
    const CellGeometry<Element>& cell = group.mesh.geometry(group.cells[c]);
    BlockMoment moment;
    int n_blocks = 0;
    for_each_block(group.points, group.cells[c], [&](const PointBlock<2>&, Index) { ++n_blocks; });
    if (within[c] != 0.0 && n_blocks == 1)
      for (int i = 0; i < 4; ++i)
        moment[i] = {{{full[c][4 * i], full[c][4 * i + 1]}, {full[c][4 * i + 2], full[c][4 * i + 3]}}};
    else {
      SoilPlace soil_of_cell;
      for_each_block(group.points, group.cells[c], [&](const PointBlock<2>& other, Index) {
        if (context.method.b_bar || other.data == block.data) soil_of_cell.add(cell, other);
      });
      PerCorner<Element, Vec<2>> volume_gradient;
      for (int i = 0; i < 4; ++i)
        for (int d = 0; d < 2; ++d) volume_gradient[i][d] = geometry.centre_gradient[i][d][c];
      moment = moment_of_points(cell, block, total(gauss.weight)[c], soil_of_cell.mean, volume_gradient);
    }
    const BlockMass soil(block);
    const Real rho = soil.mass / soil.volume;
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d)
        for (int e = 0; e < 2; ++e) balance[c].moment[i][d][e] += rho * moment[i][d][e];
    if (forces.empty()) continue;
    Vec<2> pull{0.0, 0.0};  // the part of G that is not rho (a_K - g)
    const Real held = context.held.act() ? mean_held_share(block, context.held_row, context.held) : 0.0;
    for (int d = 0; d < 2; ++d) pull[d] = rho * held * context.gravity[d];
    if (context.pore != nullptr && within[c] == 0.0) {
      const Vec<2> all = add_pull_of_points<Element>(cell, block,
          pull_at_corners<Element>(*context.pore, group.mesh.cells[group.cells[c]], material.stores_effective),
          material.is_drained() ? material.density : 0.0, nullptr);
      for (int d = 0; d < 2; ++d) pull[d] += (1.0 - held) * all[d] / soil.volume;
    } else if (context.pore != nullptr) {
      const auto at =
          pore_at_corners<Element>(*context.pore, group.mesh.cells[group.cells[c]], material.stores_effective);
      const Real share = (1.0 - held) * (material.is_drained() ? soil.mass / (material.density * soil.volume) : 1.0);
      for (int i = 0; i < 4; ++i)
        for (int d = 0; d < 2; ++d) pull[d] += share * at.pressure[i] * cell.centre_gradient[i][d];
    }
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) forces[c][d][i] -= moment[i][d][0] * pull[0] + moment[i][d][1] * pull[1];
  }
}

}  // namespace terp
