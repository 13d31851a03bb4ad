// MPM-GP, paper Sec. 2.2: the material points own the history; Gauss points only carry force and strain.
#include "schemes/gauss_gather.hpp"
#include "schemes/scheme.hpp"

namespace terp {
namespace {

template <class Element>
struct MpmGp {
  static constexpr int dim = Element::dim;

  /// Gauss stress and internal force, Eqs. (1) to (4). The state stays at the points; of the Gauss values the pressure
  /// is kept.
  static void gather(const SchemeContext& context, const CellGroup<Element>& group)
  {
    integrate(
        context, group, [&](const BlockLayer& layer, auto& gauss) { sum_layer(group, layer, gauss); },
        [&](const BlockLayer& layer, const auto& gauss) {
          for (int c = 0; c < group.n(); ++c)
            if (layer.block[c] >= 0) group.pressure[layer.block[c]] = gauss.pressure[c];
        });
  }

  /// New stress and state in each material point from the strain of its own Gauss point (instead of Steps 3 and 4).
  static void update_stress(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums& sums)
  {
    const auto strain = strain_by_cell(strain_of_group(group, du, context.method.b_bar));  // Step 2
    for (int c = 0; c < group.n(); ++c) {
      prefetch_next(group, c);
      for_each_block(group.points, group.cells[c], [&](const PointBlock<dim>& block, Index b) {
        update_excess(context, block, group.excess, b, share_of_cell_pressure(context.method), strain[c]);
        update_points(context, block, strain[c], group.pressure[b], sums);
      });
    }
  }

  /// With shares that overlap: the same in four passes.
  static void sum_patches(const SchemeContext& context, const CellGroup<Element>& group)
  {
    sum_over_patches(context, group, [](const auto&) { return std::span<const int>(); });
  }

  static void integrate_patches(const SchemeContext& context, const CellGroup<Element>& group)
  {
    integrate(
        context, group,
        [&](const BlockLayer& layer, auto& gauss) { collect_layer<Element>(group, layer, gauss, nullptr, 0); },
        [&](const BlockLayer& layer, const auto& gauss) {
          PerGauss<Element, Pack> pressure;
          pressure.fill(gauss.pressure);
          leave_row(group, layer, patch_pressure, pressure);
        });
  }

  static void leave_strain(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums&)
  {
    const auto strain = strain_of_group(group, du, context.method.b_bar);  // Step 2
    const bool rotates = context.method.objective_rate == ObjectiveRate::jaumann;
    for_each_layer(group, [&](const BlockLayer& layer) {
      leave_four_rows(
          group, layer, patch_strain, [&](int k) -> const auto& { return strain.d_eps[k]; });
      if (rotates || looks_around(context, layer.material)) leave_row(group, layer, patch_spin, strain.d_spin);
    });
  }

  static void update_from_patches(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>&, StressSums& sums)
  {
    for (int c = 0; c < group.n(); ++c) {
      prefetch_next(group, c);
      prefetch_extents(context, group, c);
      const Real size = std::sqrt(group.mesh.geometry(group.cells[c]).volume);
      for_each_block(group.points, group.cells[c], [&](const PointBlock<dim>& block, Index b) {
        const PatchView patch = view_patch(group, b, patch_rows);
        update_excess_from_patch(context, group, b, size, patch, patch_strain, share_of_cell_pressure(context.method));
        PressureAbove above;
        if (block.n_padded() > strip_length)  // several strips: their mean comes first
          for (Index p = 0; p < block.n_padded(); p += pack_width) {
            PointShares shares;
            set_shares(block, p, context.inverse_extent, size, shares);
            above.add(block, p, patch.at_points<1>(shares, patch_pressure)[0]);
          }
        for (Index first = 0; first < block.n_padded(); first += strip_length)
          update_strip_from_patch(context, block, first, size, patch, above, sums);
      });
    }
  }

 private:
  /// Rows that Gauss points leave for the points around them.
  static constexpr int patch_strain = 0, patch_pressure = 4, patch_spin = 5, patch_rows = 6;
  static_assert(patch_pressure == n_sym<dim>);

  /// Pressure of the points of a block above that around them.
  struct PressureAbove {
    Pack above = Pack(0.0), volume = Pack(0.0);  ///< sums over points, times Omega_p

    void add(const PointBlock<dim>& block, Index p, Pack around)
    {
      const Pack omega = Pack::load(block.row(PointRows<dim>::volume) + p);
      above = fma(omega, mean_stress(stress_of(block, p)) - around, above);
      volume += omega;
    }
    Pack mean() const { return Pack(sum(above) / sum(volume)); }
  };

  /// sum, finish: as in gather_at_gauss_points. The Gauss values of a group of one layer need no place in memory.
  template <class Sum, class Finish>
  static void integrate(const SchemeContext& context, const CellGroup<Element>& group, Sum&& sum, Finish&& finish)
  {
    GaussValues<Element, Pack> only;
    const bool one_layer = has_one_layer(group);
    gather_at_gauss_points(
        context, group,
        [&](const BlockLayer& layer) -> GaussValues<Element, Pack>& {
          return one_layer ? only : group.gauss_of(layer);
        },
        sum, finish);
  }

  /// above: of the whole block where it has more than one strip, else nothing yet.
  static void update_strip_from_patch(const SchemeContext& context, const PointBlock<dim>& block, Index first,
      Real size, const PatchView& patch, PressureAbove above, StressSums& sums)
  {
    const Index n = std::min(strip_length, block.n_padded() - first);
    StripArrays<dim> strip;
    alignas(64) Real pressure[strip_length];
    const bool rotates = context.method.objective_rate == ObjectiveRate::jaumann;
    const bool needs_spin = rotates || looks_around(context, block.material);
    for (Index p = 0; p < n; p += pack_width) {
      PointShares shares;
      set_shares(block, first + p, context.inverse_extent, size, shares);
      const auto values = patch.at_points<patch_pressure + 1>(shares, patch_strain);
      SymTensor<Pack, dim> d_eps;
      for (int k = 0; k < n_sym<dim>; ++k) d_eps[k] = values[k];
      store_strain(d_eps, strip, p);
      values[patch_pressure].store(pressure + p);
      if (needs_spin) patch.at_points<1>(shares, patch_spin)[0].store(strip.d_spin + p);
      if (block.n_padded() <= strip_length) above.add(block, first + p, values[patch_pressure]);
    }
    const Pack shift = above.mean(), share(share_of_cell_pressure(context.method));
    for (Index p = 0; p < n; p += pack_width) {
      SymTensor<Pack, dim> sigma = stress_of(block, first + p);
      add_isotropic(sigma, share * (Pack::load(pressure + p) + shift - mean_stress(sigma)));
      if (rotates) rotate_stress(sigma, Pack::load(strip.d_spin + p));
      store_rows(sigma.c, block, PointRows<dim>::sigma, first + p);
    }
    update_strip(context, block, first, n, strip);
    sums.plastic_work += sum_plastic_work(block, first, n, strip);
    for (Index p = 0; p < n; p += pack_width) add_strain(block, first + p, strip, p);
  }

  static Pack mean_stress(const SymTensor<Pack, dim>& sigma) { return trace(sigma) * Pack(1.0 / 3.0); }

  /// What a point takes of the difference between the pressure of its cell and its own (reading R10).
  static Real share_of_cell_pressure(const MethodOptions& method)
  {
    return method.point_pressure == PointPressure::cell    ? 1.0
           : method.point_pressure == PointPressure::relax ? method.pressure_relaxation
                                                           : 0.0;
  }

  static void update_points(const SchemeContext& context, const PointBlock<dim>& block,
      const GaussStrain<Element>& strain, Real cell_pressure, StressSums& sums)
  {
    for (Index first = 0; first < block.n_padded(); first += strip_length) {
      const Index n = std::min(strip_length, block.n_padded() - first);
      StripArrays<dim> strip;
      for (Index p = 0; p < n; p += pack_width)
        prepare_points(context.method, block, first + p, strain, cell_pressure, strip, p);
      if (looks_around(context, block.material))
        for (Index p = 0; p < n; p += pack_width)
          Element::at_sub_cell(strain.d_spin, upper_halves<Element>(block, first + p)).store(strip.d_spin + p);
      update_strip(context, block, first, n, strip);
      sums.plastic_work += sum_plastic_work(block, first, n, strip);
      for (Index p = 0; p < n; p += pack_width) add_strain(block, first + p, strip, p);
    }
  }

  /// Start stress (reading R10, objective rate) and strain increment of eight points.
  static void prepare_points(const MethodOptions& method, const PointBlock<dim>& block, Index p,
      const GaussStrain<Element>& strain, Real cell_pressure, StripArrays<dim>& strip, Index at)
  {
    const auto upper = upper_halves<Element>(block, p);
    store_strain(strain_at_points(strain, upper), strip, at);
    if (method.point_pressure == PointPressure::own && method.objective_rate == ObjectiveRate::none) return;

    SymTensor<Pack, dim> sigma = stress_of(block, p);
    add_isotropic(sigma, Pack(share_of_cell_pressure(method)) * (Pack(cell_pressure) - trace(sigma) * Pack(1.0 / 3.0)));
    if (method.objective_rate == ObjectiveRate::jaumann)
      rotate_stress(sigma, Element::at_sub_cell(strain.d_spin, upper));
    store_rows(sigma.c, block, PointRows<dim>::sigma, p);
  }
};

// Rows: sigma, strain, Omega and one state variable, read and written. Flops: sub-cell sums 36; an elastic law 30.
constexpr PassCost gather_cost{.flops = 4 + 32, .rows = 1 + 4};
constexpr PassCost stress_cost{.flops = 6 + 20 + 30 + 9, .rows = 2 * (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(mpm_gp, MpmGp, .title = "MPM-GP",
    .summary = "material points own the history, Gauss points carry force and strain",
    .unused_options = "state_averaging", .gather_cost = gather_cost, .stress_cost = stress_cost,
    TERP_OVERLAP_FUNCTIONS(MpmGp))

}  // namespace terp
