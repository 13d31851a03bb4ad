// The coupling of two nodes is that of the finite element Laplace operator, with its sign: exact second moments on
// rectangles and parallelograms. Cut off at zero it would spread 1.7 times too far along cells twice as long as wide;
// with the sign a value falls below zero by less than 1 % of the largest there (decision 0045).

#include "mpm/kernels/node_diffusion.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace terp {
namespace {

using Element = Mesh<2>::Element;

/// Adds -int grad N_i . grad N_j of the cells around a node, by neighbour.
void add_couplings(const Mesh<2>& mesh, Index i, std::map<Index, Real>& couplings)
{
  for (Index k = mesh.first_cell_of_node[i]; k < mesh.first_cell_of_node[i + 1]; ++k) {
    const auto [cell, own] = mesh.cells_of_node[k];
    const CellGeometry<Element>& geometry = mesh.geometry(cell);
    for (unsigned other = 0; other < Element::n_corners; ++other) {
      if (other == own) continue;
      Real& coupling = couplings[mesh.cells[cell][other]];
      for (int g = 0; g < Element::n_gauss; ++g)
        for (int d = 0; d < Element::dim; ++d)
          coupling -= geometry.gradient[own][d][g] * geometry.gradient[other][d][g] * geometry.gauss_volume[g];
    }
  }
}

Real full_volume_of(const Mesh<2>& mesh, Index i)
{
  Real volume = 0.0;
  for (Index k = mesh.first_cell_of_node[i]; k < mesh.first_cell_of_node[i + 1]; ++k) {
    const auto [cell, own] = mesh.cells_of_node[k];
    for (int g = 0; g < Element::n_gauss; ++g)
      volume += Element::shape_functions(Element::gauss_place(g))[own] * mesh.geometry(cell).gauss_volume[g];
  }
  return volume;
}

Real mean_area_around(const Mesh<2>& mesh, Index i)
{
  Real area = 0.0;
  const Index first = mesh.first_cell_of_node[i], end = mesh.first_cell_of_node[i + 1];
  for (Index k = first; k < end; ++k) area += mesh.geometry(mesh.cells_of_node[k].cell).volume;
  return area / static_cast<Real>(end - first);
}

/// As many sub-steps as keep the share of its own value that a node keeps above zero.
int count_substeps(const NodeDiffusion& diffusion, Real length)
{
  constexpr Real round_off = 1e-9;
  Real most = 0.0;
  const auto variance = [&](Index i) { return variance_to_spread(length * length, diffusion.mapping_variance[i]); };
  for (Index g = 0; g < diffusion.n_groups(); ++g)
    for (Index c = 0, i = pack_width * g; c < pack_width; ++c, ++i) {
      Real taken = 0.0;
      for (Index k = diffusion.first[g]; k < diffusion.first[g + 1]; ++k)
        if (const Real coupling = diffusion.coupling[k][c]; coupling > 0.0)
          taken += coupling * 0.25 * (variance(i) + variance(i + diffusion.offset[k]));
      if (taken > 0.0) most = std::max(most, taken / diffusion.full_volume[i]);
    }
  return std::max(1, static_cast<int>(std::ceil(most - round_off)));
}

/// Adds the entries of the nodes 8 g ... 8 g + 7.
void add_group(const Mesh<2>& mesh, Index g, NodeDiffusion& diffusion)
{
  std::map<Index, std::array<Real, pack_width>> entries;  // by offset
  for (Index c = 0, i = pack_width * g; c < pack_width && i < mesh.n_nodes(); ++c, ++i) {
    std::map<Index, Real> couplings;
    add_couplings(mesh, i, couplings);
    for (const auto& [j, coupling] : couplings) entries[j - i][c] = coupling;
  }
  for (const auto& [offset, couplings] : entries) {
    alignas(64) std::array<Real, pack_width> lanes = couplings;
    diffusion.offset.push_back(offset);
    diffusion.coupling.push_back(Pack::load(lanes.data()));
  }
  diffusion.first.push_back(static_cast<Index>(diffusion.offset.size()));
}

}  // namespace

NodeDiffusion make_node_diffusion(const Mesh<2>& mesh, Real length)
{
  NodeDiffusion diffusion;
  diffusion.full_volume = diffusion.mapping_variance = NodeNumbers(mesh.n_nodes());
  for (Index i = 0; i < mesh.n_nodes(); ++i) {
    diffusion.full_volume[i] = full_volume_of(mesh, i);
    diffusion.mapping_variance[i] = spread_by_mapping * mean_area_around(mesh, i);
  }
  diffusion.first.push_back(0);
  for (Index g = 0; pack_width * g < mesh.n_nodes(); ++g) add_group(mesh, g, diffusion);
  diffusion.n_substeps = count_substeps(diffusion, length);
  return diffusion;
}

}  // namespace terp
