// The coupling of two nodes is that of the finite element Laplace operator, with its sign: exact second moments on
// rectangles and parallelograms. Cut off at zero it would spread 1.7 times too far along cells twice as long as wide;
// with the sign a value falls below zero by less than 1 % of the largest there (decision 0045).

#include "transfer/node_diffusion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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
  for (Index i = 0; i + 1 < static_cast<Index>(diffusion.first.size()); ++i) {
    Real taken = 0.0;
    for (Index k = diffusion.first[i]; k < diffusion.first[i + 1]; ++k)
      taken += std::max(0.0, diffusion.coupling[k]) * 0.25 * (variance(i) + variance(diffusion.neighbour[k]));
    most = std::max(most, taken / diffusion.full_volume[i]);
  }
  return std::max(1, static_cast<int>(std::ceil(most - round_off)));
}

/// Cells by the distance from the cells of a run, that of cells which share a node being one.
class Rings {
 public:
  explicit Rings(const Mesh<2>& mesh) : mesh_(mesh), seen_(mesh.cells.size(), -1) {}

  /// Cells within n rings of those of a run, ascending.
  const std::vector<Index>& around(Index run, int n)
  {
    found_.clear();
    for (Index cell = run * reach_run; cell < std::min((run + 1) * reach_run, mesh_.n_cells()); ++cell)
      enter(cell, run);
    for (std::size_t begin = 0; n > 0; --n) {
      const std::size_t end = found_.size();
      for (; begin < end; ++begin)
        for (const Index i : mesh_.cells[found_[begin]])
          for (Index k = mesh_.first_cell_of_node[i]; k < mesh_.first_cell_of_node[i + 1]; ++k)
            enter(static_cast<Index>(mesh_.cells_of_node[k].cell), run);
    }
    return found_;
  }

 private:
  void enter(Index cell, Index run)
  {
    if (std::exchange(seen_[cell], run) != run) found_.push_back(cell);
  }

  const Mesh<2>& mesh_;
  std::vector<Index> seen_, found_;
};

/// Each sub-step reaches one ring further; one ring more completes the nodes at the edge, and one is for points that
/// moved to the next cell within the step.
void find_reached(const Mesh<2>& mesh, NodeDiffusion& diffusion)
{
  Rings rings(mesh);
  const Index n_runs = (mesh.n_cells() + reach_run - 1) / reach_run;
  diffusion.first_reached.push_back(0);
  for (Index run = 0; run < n_runs; ++run) {
    std::vector<Index> runs;
    for (const Index cell : rings.around(run, diffusion.n_substeps + 2)) runs.push_back(cell / reach_run);
    std::ranges::sort(runs);
    const auto rest = std::ranges::unique(runs);
    diffusion.reached.insert(diffusion.reached.end(), runs.begin(), rest.begin());
    diffusion.first_reached.push_back(static_cast<Index>(diffusion.reached.size()));
  }
  for (Index i = 0; i < mesh.n_nodes(); ++i)
    diffusion.run_of_node.push_back(
        static_cast<Index>(mesh.cells_of_node[mesh.first_cell_of_node[i]].cell) / reach_run);
}

}  // namespace

NodeDiffusion make_node_diffusion(const Mesh<2>& mesh, Real length)
{
  NodeDiffusion diffusion;
  diffusion.first.push_back(0);
  for (Index i = 0; i < mesh.n_nodes(); ++i) {
    std::map<Index, Real> couplings;
    add_couplings(mesh, i, couplings);
    for (const auto& [j, coupling] : couplings) {
      diffusion.neighbour.push_back(j);
      diffusion.coupling.push_back(coupling);
    }
    diffusion.first.push_back(static_cast<Index>(diffusion.neighbour.size()));
    diffusion.full_volume.push_back(full_volume_of(mesh, i));
    diffusion.mapping_variance.push_back(spread_by_mapping * mean_area_around(mesh, i));
  }
  diffusion.n_substeps = count_substeps(diffusion, length);
  find_reached(mesh, diffusion);
  return diffusion;
}

NodeSpread::NodeSpread(const NodeDiffusion& diffusion) : rate(diffusion.neighbour.size(), 0.0)
{
  for (auto* values : {&value, &next, &inverse_volume, &filling, &variance})
    values->assign(diffusion.full_volume.size(), 0.0);
}

}  // namespace terp
