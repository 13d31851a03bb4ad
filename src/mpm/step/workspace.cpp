// `fit` sets the sizes anew whenever cells fill or empty, of arrays that all steps need and of those of each feature.

#include "mpm/step/workspace.hpp"

#include "math/pack.hpp"
#include "mpm/features/feature.hpp"
#include "mpm/step/passes.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"

#include <algorithm>
#include <bit>

namespace terp {
namespace {

void list_active_nodes(const Mesh<2>& mesh, const std::vector<Index>& cells, Workspace& work)
{
  work.node_bits.assign((mesh.nodes.size() + 63) / 64, 0);
  for (const Index cell : cells)
    for (const Index i : mesh.cells[cell]) work.node_bits[i / 64] |= std::uint64_t{1} << (i % 64);
  work.active_nodes.clear();
  for (std::size_t word = 0; word < work.node_bits.size(); ++word)
    for (std::uint64_t bits = work.node_bits[word]; bits != 0; bits &= bits - 1)
      work.active_nodes.push_back(static_cast<Index>(64 * word) + std::countr_zero(bits));
}

}  // namespace

Workspace::Workspace(const StepModel& model, const StepState& state)
    : threads(model.threads), seconds(n_passes), gravity(model.gravity)
{
  node.make_anew(model.mesh->nodes.size());
  if (model.scheme->keeps_gauss_values)
    for (const SoilMaterial& material : model.materials) n_gauss_rows = std::max(n_gauss_rows, material.n_rows());
  active_nodes.reserve(model.mesh->nodes.size());
  node_sums.reserve(Threads::n_chunks(model.mesh->n_nodes(), nodes_per_chunk));
  point_leaving.resize(state.points.n_rows());
  points_leaving.resize(threads.count());
  for (auto& list : points_leaving) list.reserve(state.points.n_points());
  cell_sums.reserve(Threads::n_chunks(static_cast<Index>(2 * state.points.occupied().size()), cells_per_chunk));
  fit(model, state);
}

void Workspace::fit(const StepModel& model, const StepState& state)
{
  const auto& cells = state.points.occupied();
  fit_array(cells.size(), corners);
  fit_array(static_cast<std::size_t>(state.points.n_blocks()), pressure);
  const std::size_t n_gauss = model.materials.size() * state.points.n_bodies() *
                              Threads::n_chunks(static_cast<Index>(cells.size()), pack_width);
  if (gauss.size() < n_gauss) {
    gauss.make_anew(2 * n_gauss);
    gauss_rows.make_anew(2 * n_gauss * static_cast<std::size_t>(n_gauss_rows));
  }
  list_active_nodes(*model.mesh, cells, *this);
  cell_sums.resize(Threads::n_chunks(static_cast<Index>(cells.size()), cells_per_chunk));
  node_sums.resize(Threads::n_chunks(static_cast<Index>(active_nodes.size()), nodes_per_chunk));
  for (const Feature* feature : all_features())
    if (feature->fit != nullptr) feature->fit(model, state, *this);
}

}  // namespace terp
