// Standard MPM: force and strain at the material points, with B at the point. The baseline: it locks and oscillates.
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/schemes/scheme.hpp"
#include "mpm/step/now.hpp"

namespace terp {
namespace {

void add_force(BlockNow& now) { add_internal_force_of_points(now.geometry(), now.block, now.at.group.corners[now.c]); }

/// du_a/dx_b at eight points.
auto gradient_of(const BlockNow& now, Index p)
{
  const auto& geometry = now.at.group.mesh.geometry(now.at.group.cells[now.c]);
  return displacement_gradient(gradients_at(geometry, load_rows<2>(now.block, Rows::xi, p)), now.at.du[now.c]);
}

void start_stress(BlockNow& now, Index p, StripArrays<2>& strip, Index at)
{
  const auto l = gradient_of(now, p);
  const SymTensor<Pack, 2> d_eps = symmetric_part(l);
  store_strain(d_eps, strip, at);
  SymTensor<Pack, 2> sigma = stress_of(now.block, p);
  now.sums().take(sigma, d_eps, Pack::load(now.block.row(Rows::volume) + p));
  if (now.context().method.objective_rate == ObjectiveRate::none) return;

  rotate_stress(sigma, (l[1][0] - l[0][1]) * Pack(0.5));
  store_rows(sigma.c, now.block, Rows::sigma, p);
}

void update_block(BlockNow& now)
{
  const PointBlock<2>& block = now.block;
  for (Index first = 0; first < block.n_padded(); first += strip_length) {
    const Index n = std::min(strip_length, block.n_padded() - first);
    StripArrays<2> strip;
    for (Index p = 0; p < n; p += pack_width) start_stress(now, first + p, strip, p);
    if (now.material.type->looks_around)
      for (Index p = 0; p < n; p += pack_width) {
        const auto l = gradient_of(now, first + p);
        ((l[1][0] - l[0][1]) * Pack(0.5)).store(strip.d_spin + p);
      }
    run_strip(now, first, n, strip);
    update_strip(now.context(), block, first, n, strip);
    now.sums().plastic_work += sum_plastic_work(block, first, n, strip);
    for (Index p = 0; p < n; p += pack_width) add_strain(block, first + p, strip, p);
  }
}

constexpr Kernel kernels[] = {
    {ScorePlace::point_force, "points", &add_force},
    {ScorePlace::law, "points", &update_block},
};

// Rows: sigma, strain, Omega and one state variable, read and written. Flops: gradients 44, force or strain 28; an
// elastic law 30; for the ledger 10.
constexpr PassCost gather_cost{.flops = 3 + 44 + 28, .rows = 1 + 4};
constexpr PassCost stress_cost{.flops = 44 + 28 + 20 + 30 + 10 + 9, .rows = 2 * (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(standard_mpm, .title = "standard MPM",
    .summary = "points carry strain and force; the baseline, which locks and oscillates",
    .unused_options = "as shares weights filled_fraction b_bar cut_cells strain_shares volume_change pressure",
    .locks = true, .gather_cost = gather_cost, .stress_cost = stress_cost, .own_shares = kernels,
    .home_of_own_shares = at_points)

}  // namespace terp
