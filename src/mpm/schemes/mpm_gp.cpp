// MPM-GP, paper Sec. 2.2: the material points own the history; Gauss points only carry force and strain.
#include "mpm/features/patch_rows.hpp"
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/schemes/scheme.hpp"
#include "mpm/step/gauss_passes.hpp"

namespace terp {
namespace {

void sum_sub_cells(LayerNow& now)
{
  sum_layer(now.at.group, now.layer, now.gauss);
  enter_volume(now);
}

/// Of the Gauss values the pressure of Eq. (2) is all that the second half of the step needs.
void keep_pressure(LayerNow& now)
{
  for (int c = 0; c < now.at.group.n(); ++c)
    if (now.layer.block[c] >= 0) now.at.group.pressure[now.layer.block[c]] = now.gauss.pressure[c];
}

/// Law and strain of a strip whose points have the stress to start from.
void update_strip_of(BlockNow& now, Index first, Index n, StripArrays<2>& strip)
{
  update_strip(now.context(), now.block, first, n, strip);
  now.sums().plastic_work += sum_plastic_work(now.block, first, n, strip);
  for (Index p = 0; p < n; p += pack_width) add_strain(now.block, first + p, strip, p);
}

/// Sets the pressure of eight points, which the step begins with, and turns their stress by the spin of strip.
void start_stress(BlockNow& now, Index p, Pack half_compliance, Pack pressure, const StripArrays<2>& strip, Index at)
{
  SymTensor<Pack, 2> sigma = stress_of(now.block, p);
  const Pack before = trace(sigma) * Pack(1.0 / 3.0), omega = Pack::load(now.block.row(Rows::volume) + p);
  now.sums().set_pressure(half_compliance, omega, before, pressure);
  add_isotropic(sigma, pressure - before);
  now.sums().take(sigma, strain_of(strip, at), omega);
  if (now.context().method.objective_rate == ObjectiveRate::jaumann)
    rotate_stress(sigma, Pack::load(strip.d_spin + at));
  store_rows(sigma.c, now.block, Rows::sigma, p);
}

bool needs_spin(const BlockNow& now)
{
  return now.at.step.context.method.objective_rate == ObjectiveRate::jaumann || now.material.type->looks_around;
}

/// New stress and state in each material point from the strain of its own Gauss point (instead of Steps 3 and 4).
void update_block(BlockNow& now)
{
  const PointBlock<2>& block = now.block;
  const HalfCompliance compliance(now.material);
  const Pack pressure = now.at.group.pressure[now.number];
  const bool spins = needs_spin(now);
  for (Index first = 0; first < block.n_padded(); first += strip_length) {
    const Index n = std::min(strip_length, block.n_padded() - first);
    StripArrays<2> strip;
    for (Index p = 0; p < n; p += pack_width) {
      const auto upper = upper_halves<Quad4>(block, first + p);
      store_strain(strain_at_points(*now.strain, upper), strip, p);
      if (spins) Quad4::at_sub_cell(now.strain->d_spin, upper).store(strip.d_spin + p);
      start_stress(now, first + p, compliance.at(block, first + p), pressure, strip, p);
    }
    update_strip_of(now, first, n, strip);
  }
}

void sum_points(GroupNow& now)
{
  sum_over_patches(
      now.step.context, now.group, patches_of(now.step.work), [](const auto&) { return std::span<const int>(); });
}

void collect_patches(LayerNow& now)
{
  collect_layer<Quad4>(now.at.group, patches_of(now.at.step.work), now.layer, now.gauss, nullptr, 0);
  enter_volume(now);
}

void leave_strain(LayerNow& now)
{
  for (int k = 0; k < n_sym<2>; ++k) now.left.set(StrainRows::strain + k, now.strain->d_eps[k]);
  now.left.set(StrainRows::spin, now.strain->d_spin);
  now.left.end_with(StrainRows::ratio, StrainRows::ratio + 1, false);
  now.left.set(StrainRows::pressure, now.layer, now.at.group.pressure);
}

/// The same from what is around the points. A block keeps its mean pressure.
void update_from_patch(BlockNow& now)
{
  const PointBlock<2>& block = now.block;
  const PatchView& patch = *now.patch;
  const HalfCompliance compliance(now.material);
  const bool spins = needs_spin(now), is_whole = block.n_padded() <= strip_length;
  MeanAbove above;
  if (!is_whole)  // several strips: their mean comes first
    for (Index p = 0; p < block.n_padded(); p += pack_width)
      with_shares(block, p, now.size, [&](const auto& shares) {
        above.add(block, p, mean_stress(block, p), patch.at_points<1>(shares, StrainRows::pressure)[0]);
      });
  for (Index first = 0; first < block.n_padded(); first += strip_length) {
    const Index n = std::min(strip_length, block.n_padded() - first);
    StripArrays<2> strip;
    alignas(64) Real pressure[strip_length];
    for (Index p = 0; p < n; p += pack_width)
      with_shares(block, first + p, now.size, [&](const auto& shares) {
        constexpr int n_values = StrainRows::pressure + 1 - StrainRows::strain;
        const auto values = patch.at_points<n_values>(shares, StrainRows::strain);
        const Pack inverse = inverse_ratio(now.context(), values[StrainRows::ratio - StrainRows::strain]),
                   around_it = values[StrainRows::pressure - StrainRows::strain];
        SymTensor<Pack, 2> d_eps;
        for (int k = 0; k < n_sym<2>; ++k) d_eps[k] = inverse * values[k];
        store_strain(d_eps, strip, p);
        around_it.store(pressure + p);
        if (spins) (inverse * patch.at_points<1>(shares, StrainRows::spin)[0]).store(strip.d_spin + p);
        if (is_whole) above.add(block, first + p, mean_stress(block, first + p), around_it);
      });
    const Pack shift = above();
    for (Index p = 0; p < n; p += pack_width)
      start_stress(now, first + p, compliance.at(block, first + p), Pack::load(pressure + p) + shift, strip, p);
    run_strip(now, first, n, strip);
    update_strip_of(now, first, n, strip);
  }
}

using P = ScorePlace;
constexpr Kernel own_shares[] = {
    {P::sum, "sub-cells", &sum_sub_cells},
    {P::keep, "pressure", &keep_pressure},
    {P::law, "points", &update_block},
};
constexpr Kernel patches[] = {
    {P::patch_sums, "points", &sum_points},
    {P::sum, "patches", &collect_patches},
    {P::keep, "pressure", &keep_pressure},
    {P::gauss_law, "strain", &leave_strain},
    {P::law, "points", &update_from_patch},
};

// Rows: sigma, strain, Omega and one state variable, read and written. Flops: sub-cell sums 36; an elastic law 30; for
// the ledger 16.
constexpr PassCost gather_cost{.flops = 4 + 32, .rows = 1 + 4};
constexpr PassCost stress_cost{.flops = 6 + 20 + 30 + 16 + 9, .rows = 2 * (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(mpm_gp, .title = "MPM-GP",
    .summary = "material points own the history, Gauss points carry force and strain", .gather_cost = gather_cost,
    .stress_cost = stress_cost, .own_shares = own_shares, .patches = patches, .home_of_own_shares = cells_first,
    .home_of_patches = patched_cells)

}  // namespace terp
