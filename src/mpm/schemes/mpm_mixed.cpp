// MPM-Mixed, paper Sec. 2.1: the Gauss points own the history; material points are overwritten every step.
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/schemes/mixed_law.hpp"
#include "mpm/schemes/scheme.hpp"

namespace terp {
namespace {

void sum_sub_cells(LayerNow& now)
{
  sum_layer(now.at.group, now.layer, now.gauss);
  enter_volume(now);
}

void keep_rows(LayerNow& now)
{
  for (int k = 0; k < now.material.n_rows(); ++k) now.rows[k] = sum_row(now.at.group, now.layer, now.material.rows[k]);
  take_means_of_rows(now);
}

/// A row cell by cell, in its own place: the numbers of cell c begin at number n_gauss c.
void turn_by_cell(GaussRow<Quad4>& row)
{
  const GaussRow<Quad4> lanes = row;
  from_lanes(lanes, [&](int c) { return numbers_of(row) + Quad4::n_gauss * c; });
}

/// New stress and state at the Gauss points, and both cell by cell.
void update_layer(LayerNow& now)
{
  const GaussWork work = update_gauss_points(now);
  now.at.stress.taken += where_blocks_are(now.layer, work.power - work.plastic_beside);
  GaussLaw& law = now.law;
  law.plastic = work.plastic;
  law.compliance.emplace(now.material);
  for (int k = 0; k < n_sym<2>; ++k) from_lanes(now.gauss.sigma[k], [&](int c) { return law.sigma[c][k].data(); });
  turn_by_cell(law.plastic_work);
  for (int k = 0; k < now.material.n_state(); ++k) turn_by_cell(now.rows[k]);
}

/// Eight points take what their sub-cells have.
void assign_to_points(BlockNow& now, Index p)
{
  const LayerNow& layer = *now.layer;
  const PointBlock<2>& block = now.block;
  const auto upper = upper_halves<Quad4>(block, p);
  const auto assign = [&](const GaussRow<Quad4>& row, int to) {
    PerGauss<Quad4> value;
    std::copy_n(numbers_of(row) + Quad4::n_gauss * now.c, Quad4::n_gauss, value.begin());
    Quad4::at_sub_cell(value, upper).store(block.row(to) + p);
  };
  for (int k = 0; k < n_sym<2>; ++k)
    Quad4::at_sub_cell(layer.law.sigma[now.c][k], upper).store(block.row(Rows::sigma + k) + p);
  for (int k = 0; k < now.material.n_state(); ++k) assign(layer.rows[k], now.material.rows[k]);
  if (now.context().work_row >= 0) assign(layer.law.plastic_work, now.context().work_row);
  scale_volume(block, p, accumulate_strain(block, p, strain_at_points(*now.strain, upper)));
}

void assign_to_block(BlockNow& now)
{
  const LayerNow& layer = *now.layer;
  now.sums().plastic_work += layer.law.plastic[now.c];
  for (Index p = 0; p < now.block.n; p += pack_width) {
    now.sums().set_pressure(layer.law.compliance->at(now.block, p), Pack::load(now.block.row(Rows::volume) + p),
        mean_stress(now.block, p), layer.gauss.pressure[now.c]);
    assign_to_points(now, p);
  }
}

using P = ScorePlace;
constexpr Kernel own_shares[] = {
    {P::sum, "sub-cells", &sum_sub_cells},
    {P::keep, "rows of the law", &keep_rows},
    {P::gauss_law, "law", &update_layer},
    {P::law, "points", &assign_to_block},
};

// Rows: sigma, Omega and one state variable to gather; then strain, sigma and Omega read, and with state written.
// Flops: for the ledger 9.
constexpr PassCost gather_cost{.flops = 4 + 40, .rows = 1 + 4 + 1};
constexpr PassCost stress_cost{.flops = 9 + 9, .rows = (4 + 3 + 1) + (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(mpm_mixed, .title = "MPM-Mixed",
    .summary = "Gauss points own the history (Martinelli & Galavi 2022)",
    .with_overlap =
        "points add to their own history what the law adds at the Gauss points: none loses strength to "
        "its neighbours, and none regains any",
    .keeps_gauss_values = true, .gather_cost = gather_cost, .stress_cost = stress_cost, .own_shares = own_shares,
    .patches = mixed_patches, .home_of_own_shares = layers_first, .home_of_patches = patched_layers)

}  // namespace terp
