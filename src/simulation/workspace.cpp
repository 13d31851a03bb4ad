#include "simulation/workspace.hpp"

#include "simulation/state.hpp"

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

Workspace::Workspace(const Model& model, const State& state) : threads(model.threads), damping_local(model.damping.local)
{
  node.resize(model.mesh.nodes.size());
  active_nodes.reserve(model.mesh.nodes.size());
  node_sums.reserve(Threads::n_chunks(model.mesh.n_nodes(), nodes_per_chunk));
  leaver.resize(state.points.n_rows());
  corners.reserve(2 * state.points.occupied().size());
  gauss.reserve(2 * state.points.n_blocks());
  make_cell_sums(2 * state.points.occupied().size());
  fit(model, state);
}

void Workspace::make_cell_sums(std::size_t n_cells)
{
  const auto n_chunks = static_cast<std::size_t>(Threads::n_chunks(static_cast<Index>(n_cells), cells_per_chunk));
  for (std::size_t chunk = cell_sums.size(); chunk < n_chunks; ++chunk) {
    cell_sums.emplace_back();
    cell_sums.back().leavers.reserve(64 * cells_per_chunk);
  }
}

void Workspace::fit(const Model& model, const State& state)
{
  const auto& cells = state.points.occupied();
  corners.resize(cells.size());
  gauss.resize(state.points.n_blocks());
  list_active_nodes(model.mesh, cells, *this);
  make_cell_sums(cells.size());
  node_sums.resize(Threads::n_chunks(static_cast<Index>(active_nodes.size()), nodes_per_chunk));
}

}  // namespace terp
