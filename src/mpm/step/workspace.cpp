// The constructor reserves room for twice the cells and blocks of the start: steps ask for no memory until the soil has
// spread that far. `fit` sets the sizes anew whenever cells fill or empty; a new array needs both.

#include "mpm/step/workspace.hpp"

#include "math/errors.hpp"
#include "mpm/kernels/node_diffusion.hpp"
#include "mpm/schemes/patch_rows.hpp"
#include "mpm/schemes/patch_values.hpp"
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

std::size_t n_packs(std::size_t n) { return (n + pack_width - 1) / pack_width; }

/// Room for twice the blocks of the start.
void start_patches(const StepModel& model, const StepState& state, Index n_gauss_rows, PatchValues& patches)
{
  const std::size_t most = 2 * static_cast<std::size_t>(state.points.n_blocks());
  const int n_excess = model.has_excess_pressure() ? 1 : 0, n_work = model.slips_in_cut_cells() ? 1 : 0;
  patches.cells = find_patch_partners(*model.mesh);
  patches.excess_place = patch_others + n_gauss_rows;
  patches.sum_width = patches.excess_place + n_excess;
  patches.gauss_width =
      (model.scheme->keeps_gauss_values ? HistoryRows::end + n_work : StrainRows::end) + n_gauss_rows + n_excess;
  TERP_ASSERT(std::max(patches.sum_width, patches.gauss_width) <= PatchView::most_rows);
  patches.partners.reserve(most);
  patches.taken.reserve(most);
  patches.folds.reserve(most);
  patches.sums.reserve(n_packs(most * Patch<Quad4>::n_slots * patches.sum_width));
  patches.gauss.reserve(n_packs(most * Quad4::n_gauss * patches.gauss_width));
}

void fit_patches(const StepState& state, PatchValues& patches)
{
  const auto n = static_cast<std::size_t>(state.points.n_blocks());
  patches.partners.clear();
  patches.sums.resize(n_packs(n * Patch<Quad4>::n_slots * patches.sum_width));
  patches.gauss.resize(n_packs(n * Quad4::n_gauss * patches.gauss_width));
}

/// The slope of the pressure needs forces of the cells only where more than weight and acceleration has a part in it.
bool has_corners(const StepModel& model, int kind, const Workspace& work)
{
  if (kind == outer_balance && !model.water && model.held_row < 0) return false;
  return !work.outer[kind].node.empty();
}

}  // namespace

Workspace::Workspace(const StepModel& model, const StepState& state)
    : threads(model.threads),
      patches(std::make_unique<PatchValues>()),
      gravity(model.gravity),
      damping_local(model.damping.local)
{
  node.make_anew(model.mesh->nodes.size());
  if (model.scheme->keeps_gauss_values)
    for (const SoilMaterial& material : model.materials) n_gauss_rows = std::max(n_gauss_rows, material.n_rows());
  active_nodes.reserve(model.mesh->nodes.size());
  node_sums.reserve(Threads::n_chunks(model.mesh->n_nodes(), nodes_per_chunk));
  point_leaving.resize(state.points.n_rows());
  points_leaving.resize(threads.count());
  for (auto& list : points_leaving) list.reserve(state.points.n_points());
  const std::size_t most_cells = 2 * state.points.occupied().size();
  corners.reserve(most_cells);
  if (model.spreads_softening()) {
    softening = std::make_unique<NodeSpread>(*model.diffusion);
    softening_corners.reserve(most_cells);
    cell_softens.reserve(most_cells);
    softening_reach.has_cell.resize(model.mesh->cells.size());
    softening_reach.has_node.resize(pack_width * static_cast<std::size_t>(model.diffusion->n_groups()));
    softening_reach.cells.reserve(model.mesh->cells.size());
  }
  if (model.water || model.has_excess_pressure()) {
    outer[outer_water].acts = true;
    outer[outer_water].node.resize(model.mesh->nodes.size());
  }
  if (model.balances_pressure()) {
    balance.reserve(most_cells);
    balance_node.resize(model.mesh->nodes.size());
    outer[outer_balance].acts = true;
    outer[outer_balance].node.resize(model.mesh->nodes.size());
  }
  pressure.reserve(2 * state.points.n_blocks());
  if (model.has_excess_pressure()) excess.reserve(2 * state.points.n_blocks());
  if (model.hands_back_transposed()) ratios.reserve(2 * state.points.n_blocks());
  if (model.slips_in_cut_cells()) slips.reserve(2 * state.points.n_blocks());
  if (model.inverse_extent >= 0) start_patches(model, state, n_gauss_rows, *patches);
  load_pressure.resize(model.loads.size());
  if (model.has_loads()) outer[outer_load].node.resize(model.mesh->nodes.size());
  for (int kind = 0; kind < n_outer_kinds; ++kind)
    if (has_corners(model, kind, *this)) outer[kind].corners.reserve(most_cells);
  cell_sums.reserve(Threads::n_chunks(static_cast<Index>(most_cells), cells_per_chunk));
  fit(model, state);
}

Workspace::~Workspace() = default;

void Workspace::fit(const StepModel& model, const StepState& state)
{
  const auto& cells = state.points.occupied();
  corners.resize(cells.size());
  if (model.spreads_softening()) {
    softening_corners.resize(cells.size());
    cell_softens.resize(cells.size());
  }
  if (model.method.relaxation_time > 0.0) {
    fits.resize(cells.size());
    fitted.resize(model.mesh->nodes.size());
  }
  pressure.resize(state.points.n_blocks());
  if (model.has_excess_pressure()) excess.resize(state.points.n_blocks());
  if (model.balances_pressure()) balance.resize(cells.size());
  if (model.hands_back_transposed()) ratios.resize(state.points.n_blocks());
  if (model.slips_in_cut_cells()) slips.resize(state.points.n_blocks());
  const std::size_t n_gauss = model.materials.size() * state.points.n_bodies() *
                              Threads::n_chunks(static_cast<Index>(cells.size()), pack_width);
  if (gauss.size() < n_gauss) {
    gauss.make_anew(2 * n_gauss);
    gauss_rows.make_anew(2 * n_gauss * static_cast<std::size_t>(n_gauss_rows));
  }
  const std::size_t n_groups = Threads::n_chunks(static_cast<Index>(cells.size()), pack_width);
  if (model.takes_volume_change_of_soil() && volume_gradients.size() < n_groups)
    volume_gradients.make_anew(2 * n_groups);
  if (model.inverse_extent >= 0) fit_patches(state, *patches);
  for (int kind = 0; kind < n_outer_kinds; ++kind)
    if (has_corners(model, kind, *this)) outer[kind].corners.resize(cells.size());
  list_active_nodes(*model.mesh, cells, *this);
  cell_sums.resize(Threads::n_chunks(static_cast<Index>(cells.size()), cells_per_chunk));
  node_sums.resize(Threads::n_chunks(static_cast<Index>(active_nodes.size()), nodes_per_chunk));
}

}  // namespace terp
