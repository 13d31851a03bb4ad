// MPM-Mixed, paper Sec. 2.1: the Gauss points own the history; material points are overwritten every step.
#include "schemes/scheme.hpp"

namespace terp {
namespace {

struct MpmMixed {
  /// Gauss stress, state and internal force, Eqs. (1) to (4). Each state variable says how it is averaged (reading R9).
  static void gather(const SchemeContext& context, const CellGroup& group)
  {
    gather_at_gauss_points(
        context, group, [&](Index material) -> GaussValues<2, Pack>& { return group.gauss_of(material); },
        [&](Index material) { return context.materials[material].n_state(); },
        [&](const BlockLayer& layer, GaussValues<2, Pack>& gauss) {
          const auto states = context.materials[layer.material].type->state;
          for (std::size_t k = 0; k < states.size(); ++k)
            if (averages_over_cell(context.method, states[k])) average_state_over_cell(static_cast<int>(k), gauss);
        });
  }

  /// Steps 2 to 4 of Sec. 2.1: new stress and state at the Gauss points, assigned to the points of each sub-cell.
  static void update_stress(const SchemeContext& context, const CellGroup& group,
      std::span<const CornerVectors, pack_width> du, StressSums& sums)
  {
    const GaussStrain<2, Pack> lanes = strain_of_group(group, du, context.method.b_bar);  // Step 2
    const auto strain = strain_by_cell(lanes);
    for_each_layer(group, [&](const BlockLayer& layer) {
      const SoilMaterial& material = context.materials[layer.material];
      GaussValues<2, Pack>& gauss = group.gauss_of(layer.material);
      const Pack plastic_work = update_gauss_points(context, material, lanes, gauss);  // Step 3
      const auto values = by_cell(gauss, material.n_state());
      for (int c = 0; c < group.n(); ++c) {
        if (layer.block[c] < 0) continue;
        prefetch_next(group, c);
        sums.plastic_work += plastic_work[c];
        const PointBlock<2>& block = group.points.block(layer.block[c]);
        for (Index p = 0; p < block.n; p += pack_width)
          assign_to_points(values[c], strain[c], material.n_state(), block, p);  // Step 4
      }
    });
  }

 private:
  static bool averages_over_cell(const MethodOptions& method, const StateInfo& state)
  {
    if (method.state_averaging == StateAveraging::as_declared) return state.averaging == Averaging::cell;
    return method.state_averaging == StateAveraging::cell;
  }

  /// Runs the law on the four Gauss points of eight cells. Returns the plastic work of each cell [J per m].
  static Pack update_gauss_points(const SchemeContext& context, const SoilMaterial& material,
      const GaussStrain<2, Pack>& strain, GaussValues<2, Pack>& gauss)
  {
    if (context.method.objective_rate == ObjectiveRate::jaumann) rotate_gauss_points(strain, gauss);
    std::array<Pack, 4> plastic_work;
    StressArrays<2> arrays{};
    for (int k = 0; k < n_sym<2>; ++k) arrays.sigma[k] = numbers_of(gauss.sigma[k]);
    for (int k = 0; k < max_state; ++k) arrays.state[k] = numbers_of(gauss.state[k]);
    for (int k = 0; k < n_sym<2>; ++k) arrays.d_eps[k] = numbers_of(strain.d_eps[k]);
    arrays.plastic_work = numbers_of(plastic_work);
    arrays.n = 4 * pack_width;
    arrays.dt = context.dt;
    material.law->update(arrays);

    Pack work(0.0);
    for (int g = 0; g < 4; ++g) work += plastic_work[g] * gauss.weight[g];
    return work;
  }

  static void rotate_gauss_points(const GaussStrain<2, Pack>& strain, GaussValues<2, Pack>& gauss)
  {
    for (int g = 0; g < 4; ++g) {
      SymTensor<Pack, 2> at{{gauss.sigma[0][g], gauss.sigma[1][g], gauss.sigma[2][g], gauss.sigma[3][g]}};
      rotate_stress(at, strain.d_spin[g]);
      for (int k = 0; k < n_sym<2>; ++k) gauss.sigma[k][g] = at[k];
    }
  }

  /// Stress and state cell by cell.
  static std::array<GaussValues<2>, pack_width> by_cell(const GaussValues<2, Pack>& lanes, int n_state)
  {
    std::array<GaussValues<2>, pack_width> gauss;
    for (int k = 0; k < n_sym<2>; ++k) from_lanes(lanes.sigma[k], [&](int c) { return gauss[c].sigma[k].data(); });
    for (int k = 0; k < n_state; ++k) from_lanes(lanes.state[k], [&](int c) { return gauss[c].state[k].data(); });
    return gauss;
  }

  static void assign_to_points(
      const GaussValues<2>& gauss, const GaussStrain<2>& strain, int n_state, const PointBlock<2>& block, Index p)
  {
    using Rows = PointRows<2>;
    const Mask right = right_half(block, p), upper = upper_half(block, p);
    for (int k = 0; k < n_sym<2>; ++k)
      at_sub_cell<Pack>(gauss.sigma[k], right, upper).store(block.row(Rows::sigma + k) + p);
    for (int k = 0; k < n_state; ++k)
      at_sub_cell<Pack>(gauss.state[k], right, upper).store(block.row(Rows::state + k) + p);
    scale_volume(block, p, accumulate_strain(block, p, strain_at_points(strain, right, upper)));
  }
};

// Rows: sigma, Omega and one state variable to gather; then strain and Omega read, and with sigma and state written.
constexpr PassCost gather_cost{.flops = 4 + 40, .rows = 1 + 4 + 1};
constexpr PassCost stress_cost{.flops = 9, .rows = (4 + 1) + (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(mpm_mixed, MpmMixed, .title = "MPM-Mixed",
    .summary = "Gauss points own the history (Martinelli & Galavi 2022)",
    .unused_options = "point_pressure pressure_relaxation", .keeps_gauss_values = true, .gather_cost = gather_cost,
    .stress_cost = stress_cost)

}  // namespace terp
