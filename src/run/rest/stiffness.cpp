// Points count to the sub-cell that they lie in, also where their shares overlap: a stiffness that is a little off
// costs iterations and changes no result.

#include "run/rest/stiffness.hpp"

#include "mpm/features/sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace terp {
namespace {

constexpr int n_dof = 2 * Quad4::n_corners;
using CellMatrix = std::array<std::array<Real, n_dof>, n_dof>;
using StrainMatrix = std::array<std::array<Real, n_dof>, 4>;  // rows: xx, yy, zz, gamma_xy

constexpr Real of_sides = 1e4;          // over the largest sum of a row: sides move by 1e-4 of what soil does
constexpr Real of_light_nodes = 1e-10;  // over the same: nodes with next to no soil keep a factor

StrainMatrix strain_matrix(const CellGeometry<Quad4>& cell, int g, bool b_bar)
{
  StrainMatrix b{};
  for (int i = 0; i < Quad4::n_corners; ++i)
    for (int d = 0; d < 2; ++d) {
      const Real gradient = cell.gradient[i][d][g];
      const Real shift = b_bar ? (cell.centre_gradient[i][d] - gradient) / 3.0 : 0.0;
      for (int k = 0; k < 3; ++k) b[k][2 * i + d] = shift + (k == d ? gradient : 0.0);
      b[3][2 * i + 1 - d] = gradient;
    }
  return b;
}

/// Adds w B^T D B.
void add(const StrainMatrix& b, Moduli soil, Real weight, CellMatrix& k)
{
  const Real lambda = soil.bulk - 2.0 / 3.0 * soil.shear;
  for (int n = 0; n < n_dof; ++n) {
    const Real volume = lambda * (b[0][n] + b[1][n] + b[2][n]);
    const std::array<Real, 4> sigma{2.0 * soil.shear * b[0][n] + volume, 2.0 * soil.shear * b[1][n] + volume,
        2.0 * soil.shear * b[2][n] + volume, soil.shear * b[3][n]};
    for (int m = 0; m < n_dof; ++m)
      for (int r = 0; r < 4; ++r) k[m][n] += weight * b[r][m] * sigma[r];
  }
}

/// Volume by sub-cell, and means over the points.
struct BlockSums {
  PerGauss<Quad4> volume{};
  Real all = 0.0;
  Moduli mean{.bulk = 0.0, .shear = 0.0};
};

BlockSums sum_block(const SoilMaterial& material, const PointBlock<2>& block)
{
  BlockSums sums;
  for (Index p = 0; p < block.n; ++p) {
    const Real volume = block.row(Rows::volume)[p];
    const int g = (block.row(Rows::xi)[p] >= 0.0 ? 1 : 0) + (block.row(Rows::xi + 1)[p] >= 0.0 ? 2 : 0);
    const Moduli soil = material.type->stiffness_by_stress
                            ? material.law->moduli_at(material.view(block, p), stress_at(block, p))
                        : material.varies() ? material.law->moduli(material.view(block, p))
                                            : material.law->moduli();
    sums.volume[g] += volume, sums.all += volume;
    sums.mean.bulk += volume * soil.bulk, sums.mean.shear += volume * soil.shear;
  }
  sums.mean.bulk /= sums.all, sums.mean.shear /= sums.all;
  return sums;
}

CellMatrix stiffness_of_cell(const Model& model, const PointBlocks<2>& points, Index cell)
{
  const CellGeometry<Quad4>& geometry = model.mesh->geometry(cell);
  std::vector<BlockSums> blocks;
  PerGauss<Quad4> in_cell{};
  Real filled = 0.0;
  for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
    blocks.push_back(sum_block(model.materials[block.material], block));
    for (int g = 0; g < Quad4::n_gauss; ++g) in_cell[g] += blocks.back().volume[g];
    filled += blocks.back().all;
  });
  const bool is_full =
      model.method.weights == Weights::hybrid && filled >= model.method.filled_fraction * geometry.volume;
  CellMatrix k{};
  for (const BlockSums& block : blocks)
    for (int g = 0; g < Quad4::n_gauss; ++g) {
      const Real own = in_cell[g] > 0.0 ? block.volume[g] / in_cell[g] : block.all / filled;
      const Real weight = is_full ? geometry.gauss_volume[g] * own : block.volume[g];
      if (weight > 0.0) add(strain_matrix(geometry, g, model.method.b_bar), block.mean, weight, k);
    }
  return k;
}

/// Directions in which a side holds a node, times themselves. A contact that resists along itself holds there: soil
/// slips where forces beyond its strength are left.
std::array<std::array<Real, 2>, 2> held_by(const NodeSide& side)
{
  const bool resists = side.action.along == Along::resisted && (side.adhesion_force > 0.0 || side.friction > 0.0);
  if (side.action.along == Along::prescribed || resists) return {{{1.0, 0.0}, {0.0, 1.0}}};
  if (side.action.across == Across::free) return {};
  const Vec<2>& n = side.normal;
  return {{{n[0] * n[0], n[0] * n[1]}, {n[1] * n[0], n[1] * n[1]}}};
}

}  // namespace

SparseCholesky factor_stiffness(const Model& model, const State& state, const Workspace& work)
{
  const Mesh<2>& mesh = *model.mesh;
  std::vector<Index> first(mesh.nodes.size(), -1);
  Index n = 0;
  for (const Index i : work.active_nodes) first[i] = n, n += 2;
  std::vector<MatrixEntry> entries;
  entries.reserve(n_dof * n_dof * state.points.occupied().size());
  std::vector<Real> row_sum(static_cast<std::size_t>(n), 0.0);
  for (const Index cell : state.points.occupied()) {
    const CellMatrix k = stiffness_of_cell(model, state.points, cell);
    for (int a = 0; a < n_dof; ++a)
      for (int b = 0; b < n_dof; ++b) {
        const Index row = first[mesh.cells[cell][a / 2]] + a % 2, column = first[mesh.cells[cell][b / 2]] + b % 2;
        entries.push_back({row, column, k[a][b]});
        row_sum[row] += std::abs(k[a][b]);
      }
  }
  const Real largest = *std::ranges::max_element(row_sum);
  for (Index k = 0; k < n; ++k) entries.push_back({k, k, of_light_nodes * largest});
  for (const Index i : work.active_nodes)
    if (const NodeCondition* at = model.with.sides->boundary.at(i))
      for (int s = 0; s < at->n; ++s) {
        const auto held = held_by(at->sides[static_cast<std::size_t>(s)]);
        for (Index d = 0; d < 2; ++d)
          for (Index e = 0; e < 2; ++e)
            entries.push_back({first[i] + d, first[i] + e, of_sides * largest * held[d][e]});
      }
  return {n, entries};
}

}  // namespace terp
