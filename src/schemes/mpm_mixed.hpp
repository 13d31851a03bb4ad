// MPM-Mixed, paper Sec. 2.1: the Gauss points own the history; material points are overwritten every step.
#pragma once

#include "schemes/cell_view.hpp"

namespace terp {

struct MpmMixed {
  /// Gauss stress, state and internal force, Eqs. (1) to (4). Each state variable says how it is averaged (reading R9).
  static bool gather(const SchemeContext& context, const CellView& view)
  {
    return gather_at_gauss_points(
        context, view, [&](const PointBlock<2>& block) { return context.materials[block.material].n_state(); },
        [&](const PointBlock<2>& block, GaussValues<2>& gauss) {
          const auto states = context.materials[block.material].type->state;
          for (std::size_t k = 0; k < states.size(); ++k)
            if (averages_over_cell(context.method, states[k])) average_state_over_cell(static_cast<int>(k), gauss);
        });
  }

  /// Steps 2 to 4 of Sec. 2.1: new stress and state at the Gauss points, assigned to the points of each sub-cell.
  static void update_stress(const SchemeContext& context, const CellView& view, const CornerVectors& du, StressSums& sums)
  {
    const GaussStrain<2> strain = strain_at_gauss_points(view.geometry, du, context.method.b_bar);  // Step 2
    for_each_block(view.points, view.cell, [&](const PointBlock<2>& block, Index b) {
      const SoilMaterial& material = context.materials[block.material];
      sums.plastic_work += update_gauss_points(context, material, strain, view.gauss[b]);    // Step 3
      for (Index p = 0; p < block.n; p += pack_width) assign_to_points(view.gauss[b], strain, material.n_state(), block, p);  // Step 4
    });
  }

 private:
  static bool averages_over_cell(const MethodOptions& method, const StateInfo& state)
  {
    if (method.state_averaging == StateAveraging::as_declared) return state.averaging == Averaging::cell;
    return method.state_averaging == StateAveraging::cell;
  }

  /// Runs the law on the four Gauss points, in one pack with four empty lanes. Returns the plastic work [J per m].
  static Real update_gauss_points(const SchemeContext& context, const SoilMaterial& material, const GaussStrain<2>& strain,
                                  GaussValues<2>& gauss)
  {
    alignas(64) Real sigma[n_sym<2>][pack_width] = {}, state[max_state][pack_width] = {}, d_eps[n_sym<2>][pack_width] = {};
    alignas(64) Real plastic_work[pack_width] = {};
    StressArrays<2> arrays{};
    for (int k = 0; k < n_sym<2>; ++k) {
      std::copy_n(gauss.sigma[k].begin(), 4, sigma[k]);
      std::copy_n(strain.d_eps[k].begin(), 4, d_eps[k]);
      arrays.sigma[k] = sigma[k];
      arrays.d_eps[k] = d_eps[k];
    }
    for (int k = 0; k < max_state; ++k) arrays.state[k] = state[k];
    for (int k = 0; k < material.n_state(); ++k) std::copy_n(gauss.state[k].begin(), 4, state[k]);
    if (context.method.objective_rate == ObjectiveRate::jaumann) rotate_gauss_points(strain, sigma);
    arrays.plastic_work = plastic_work;
    arrays.n = pack_width;
    arrays.dt = context.dt;
    material.law->update(arrays);

    Real work = 0.0;
    for (int g = 0; g < 4; ++g) work += plastic_work[g] * gauss.weight[g];
    for (int k = 0; k < n_sym<2>; ++k) std::copy_n(sigma[k], 4, gauss.sigma[k].begin());
    for (int k = 0; k < material.n_state(); ++k) std::copy_n(state[k], 4, gauss.state[k].begin());
    return work;
  }

  static void rotate_gauss_points(const GaussStrain<2>& strain, Real (&sigma)[n_sym<2>][pack_width])
  {
    for (int g = 0; g < 4; ++g) {
      SymTensor<Real, 2> at{{sigma[0][g], sigma[1][g], sigma[2][g], sigma[3][g]}};
      rotate_stress(at, strain.d_spin[g]);
      for (int k = 0; k < n_sym<2>; ++k) sigma[k][g] = at[k];
    }
  }

  static void assign_to_points(const GaussValues<2>& gauss, const GaussStrain<2>& strain, int n_state, const PointBlock<2>& block, Index p)
  {
    using Rows = PointRows<2>;
    const Mask right = right_half(block, p), upper = upper_half(block, p);
    for (int k = 0; k < n_sym<2>; ++k) at_sub_cell<Pack>(gauss.sigma[k], right, upper).store(block.row(Rows::sigma + k) + p);
    for (int k = 0; k < n_state; ++k) at_sub_cell<Pack>(gauss.state[k], right, upper).store(block.row(Rows::state + k) + p);
    scale_volume(block, p, accumulate_strain(block, p, strain_at_points(strain, right, upper)));
  }
};

}  // namespace terp
