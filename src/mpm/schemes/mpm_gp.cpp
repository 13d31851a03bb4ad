// MPM-GP, paper Sec. 2.2: the material points own the history; Gauss points only carry force and strain.
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/schemes/gauss_gather.hpp"
#include "mpm/schemes/patch_rows.hpp"
#include "mpm/schemes/scheme.hpp"

namespace terp {
namespace {

template <class Element>
struct MpmGp {
  static constexpr int dim = Element::dim;

  /// Gauss stress and internal force, Eqs. (1) to (4). The state stays at the points; of the Gauss values the pressure
  /// is kept.
  static void gather(const SchemeContext& context, const CellGroup<Element>& group)
  {
    integrate(context, group, [&](const BlockLayer& layer, auto& gauss) { sum_layer(group, layer, gauss); });
  }

  /// New stress and state in each material point from the strain of its own Gauss point (instead of Steps 3 and 4).
  static void update_stress(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums& sums)
  {
    GroupVectors<Element> room;
    const GroupVectors<Element>& moved = without_kinks(group, du, room, sums.slip_work);
    const GaussStrain<Element, Pack> lanes = strain_of_group(group, moved, context.method.b_bar);  // Step 2
    const auto strain = strain_by_cell(lanes);
    sums.slip_work += lost_by_slipping(group);
    GaussStrain<Element> slipped;
    for (int c = 0; c < group.n(); ++c) {
      prefetch_next(group, c);
      for_each_block(group.points, group.cells[c], [&](const PointBlock<dim>& block, Index b) {
        const GaussStrain<Element>& own = handed_back(group, b, with_slip(group, b, strain[c], slipped), slipped);
        update_excess(context, group, b, own, sums);
        update_points(context, block, own, group.pressure[b], sums);
        sums.slip_work += lost_while_slipping(group, b);
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
    integrate(context, group,
        [&](const BlockLayer& layer, auto& gauss) { collect_layer<Element>(group, layer, gauss, nullptr, 0); });
  }

  static void leave_strain(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums& sums)
  {
    GroupVectors<Element> room;
    const GroupVectors<Element>& moved = without_kinks(group, du, room, sums.slip_work);
    const auto strain = strain_of_group(group, moved, context.method.b_bar);  // Step 2
    sums.slip_work += lost_by_slipping(group);
    for_each_layer(group, [&](const BlockLayer& layer) {
      LeftRows<Element> rows;
      GaussStrain<Element, Pack> slipped;
      const GaussStrain<Element, Pack>& own = with_slips(group, layer, strain, slipped);
      for (int k = 0; k < n_sym<dim>; ++k) rows.set(StrainRows::strain + k, own.d_eps[k]);
      rows.set(StrainRows::spin, own.d_spin);
      rows.weigh(group, layer, StrainRows::ratio, StrainRows::ratio + 1);
      rows.set(StrainRows::pressure, layer, group.pressure);
      if (!group.excess.empty()) rows.set(StrainRows::end, layer, group.excess);
      rows.leave(group, layer);
    });
  }

  static void update_from_patches(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>&, StressSums& sums)
  {
    for (int c = 0; c < group.n(); ++c) {
      prefetch_next(group, c);
      prefetch_extents(context, group, c);
      const PatchSize size = patch_size(context, group, group.cells[c]);
      for_each_block(group.points, group.cells[c], [&](const PointBlock<dim>& block, Index b) {
        prefetch_for_update(context, block);
        const PatchView patch = view_patch(group, b);
        MeanAbove pressure, excess;
        const int excess_row = context.materials[block.material].excess_row;
        if (block.n_padded() > strip_length)  // several strips: their mean comes first
          for (Index p = 0; p < block.n_padded(); p += pack_width)
            with_shares(block, p, size, [&](const auto& shares) {
              pressure.add(block, p, mean_stress(block, p), patch.at_points<1>(shares, StrainRows::pressure)[0]);
              if (excess_row >= 0)
                excess.add(
                    block, p, Pack::load(block.row(excess_row) + p), patch.at_points<1>(shares, StrainRows::end)[0]);
            });
        for (Index first = 0; first < block.n_padded(); first += strip_length)
          update_strip_from_patch(context, block, first, size, patch, {pressure, excess}, sums);
        sums.slip_work += lost_while_slipping(group, b);
      });
    }
  }

 private:
  /// What the points of a block have above what is around them, as a mean.
  struct MeanAbove {
    Pack above = Pack(0.0), volume = Pack(0.0);  ///< sums over points, times Omega_p

    void add(const PointBlock<dim>& block, Index p, Pack own, Pack around)
    {
      const Pack omega = Pack::load(block.row(PointRows<dim>::volume) + p);
      above = fma(omega, own - around, above);
      volume += omega;
    }
    Pack operator()() const { return Pack(sum(above) / sum(volume)); }
  };
  struct BlockMeans {
    MeanAbove pressure, excess;
  };

  /// sum: as in gather_at_gauss_points. The Gauss values of a group of one layer need no place in memory.
  template <class Sum>
  static void integrate(const SchemeContext& context, const CellGroup<Element>& group, Sum&& sum)
  {
    GaussValues<Element, Pack> only;
    const bool one_layer = has_one_layer(group);
    gather_at_gauss_points(
        context, group,
        [&](const BlockLayer& layer) -> GaussValues<Element, Pack>& {
          return one_layer ? only : group.gauss_of(layer);
        },
        sum,
        [&](const BlockLayer& layer, const auto& gauss) {
          for (int c = 0; c < group.n(); ++c)
            if (layer.block[c] >= 0) group.pressure[layer.block[c]] = gauss.pressure[c];
        });
  }

  /// above: of the whole block where it has more than one strip, else nothing yet.
  static void update_strip_from_patch(const SchemeContext& context, const PointBlock<dim>& block, Index first,
      const PatchSize& size, const PatchView& patch, BlockMeans above, StressSums& sums)
  {
    const Index n = std::min(strip_length, block.n_padded() - first);
    StripArrays<dim> strip;
    alignas(64) Real pressure[strip_length], excess[strip_length];
    const SoilMaterial& material = context.materials[block.material];
    const bool rotates = context.method.objective_rate == ObjectiveRate::jaumann, is_whole = n == block.n_padded();
    const bool needs_spin = rotates || looks_around(context, block.material), has_excess = material.excess_row >= 0;
    const bool weighed = context.method.strain_shares == StrainShares::transposed;
    for (Index p = 0; p < n; p += pack_width)
      with_shares(block, first + p, size, [&](const auto& shares) {
        constexpr int n_values = StrainRows::pressure + 1 - StrainRows::strain;
        const auto values = patch.at_points<n_values>(shares, StrainRows::strain);
        const Pack inverse = inverse_ratio(values[StrainRows::ratio - StrainRows::strain], weighed),
                   around_it = values[StrainRows::pressure - StrainRows::strain];
        SymTensor<Pack, dim> d_eps;
        for (int k = 0; k < n_sym<dim>; ++k) d_eps[k] = inverse * values[k];
        store_strain(d_eps, strip, p);
        around_it.store(pressure + p);
        if (needs_spin) (inverse * patch.at_points<1>(shares, StrainRows::spin)[0]).store(strip.d_spin + p);
        if (is_whole) above.pressure.add(block, first + p, mean_stress(block, first + p), around_it);
        if (!has_excess) return;
        const Pack around = patch.at_points<1>(shares, StrainRows::end)[0];
        around.store(excess + p);
        if (is_whole)
          above.excess.add(block, first + p, Pack::load(block.row(material.excess_row) + first + p), around);
      });
    const Pack shift = above.pressure();
    const HalfCompliance compliance(material);
    for (Index p = 0; p < n; p += pack_width) {
      SymTensor<Pack, dim> sigma = stress_of(block, first + p);
      const Pack before = trace(sigma) * Pack(1.0 / 3.0), after = Pack::load(pressure + p) + shift;
      const Pack omega = Pack::load(block.row(PointRows<dim>::volume) + first + p);
      sums.set_pressure(compliance.at(block, first + p), omega, before, after);
      add_isotropic(sigma, after - before);
      sums.take(sigma, strain_of(strip, p), omega);
      if (rotates) rotate_stress(sigma, Pack::load(strip.d_spin + p));
      store_rows(sigma.c, block, PointRows<dim>::sigma, first + p);
    }
    if (has_excess) update_excess_of_strip(context, block, first, n, {excess, above.excess()}, strip, sums);
    update_strip(context, block, first, n, strip);
    sums.plastic_work += sum_plastic_work(block, first, n, strip);
    for (Index p = 0; p < n; p += pack_width) add_strain(block, first + p, strip, p);
  }

  /// u_e at the points of a strip, and by how much that of the points is above it.
  struct ExcessAround {
    const Real* at_points;
    Pack shift;
  };
  static void update_excess_of_strip(const SchemeContext& context, const PointBlock<dim>& block, Index first, Index n,
      const ExcessAround& around, const StripArrays<dim>& strip, StressSums& sums)
  {
    const SoilMaterial& material = context.materials[block.material];
    const ExcessStep step(context, material);
    for (Index p = 0; p < n; p += pack_width) {
      Real* at = block.row(material.excess_row) + first + p;
      const Pack omega = Pack::load(block.row(PointRows<dim>::volume) + first + p);
      const Pack set_to = Pack::load(around.at_points + p) + around.shift;
      step(Pack::load(at), set_to, trace(strain_of(strip, p)), omega, sums).store(at);
    }
  }

  static void update_points(const SchemeContext& context, const PointBlock<dim>& block,
      const GaussStrain<Element>& strain, Real cell_pressure, StressSums& sums)
  {
    for (Index first = 0; first < block.n_padded(); first += strip_length) {
      const Index n = std::min(strip_length, block.n_padded() - first);
      StripArrays<dim> strip;
      const HalfCompliance compliance(context.materials[block.material]);
      for (Index p = 0; p < n; p += pack_width)
        prepare_points(
            context.method, block, first + p, strain, {cell_pressure, compliance.at(block, first + p)}, strip, p, sums);
      if (looks_around(context, block.material))
        for (Index p = 0; p < n; p += pack_width)
          Element::at_sub_cell(strain.d_spin, upper_halves<Element>(block, first + p)).store(strip.d_spin + p);
      update_strip(context, block, first, n, strip);
      sums.plastic_work += sum_plastic_work(block, first, n, strip);
      for (Index p = 0; p < n; p += pack_width) add_strain(block, first + p, strip, p);
    }
  }

  struct PressureReset {
    Pack set_to, half_compliance;
  };
  /// Start stress (reading R10, objective rate) and strain increment of eight points.
  static void prepare_points(const MethodOptions& method, const PointBlock<dim>& block, Index p,
      const GaussStrain<Element>& strain, const PressureReset& reset, StripArrays<dim>& strip, Index at,
      StressSums& sums)
  {
    const auto upper = upper_halves<Element>(block, p);
    const SymTensor<Pack, dim> d_eps = strain_at_points(strain, upper);
    store_strain(d_eps, strip, at);
    SymTensor<Pack, dim> sigma = stress_of(block, p);
    const Pack before = trace(sigma) * Pack(1.0 / 3.0), omega = Pack::load(block.row(PointRows<dim>::volume) + p);
    sums.set_pressure(reset.half_compliance, omega, before, reset.set_to);
    add_isotropic(sigma, reset.set_to - before);
    sums.take(sigma, d_eps, omega);
    if (method.objective_rate == ObjectiveRate::jaumann)
      rotate_stress(sigma, Element::at_sub_cell(strain.d_spin, upper));
    store_rows(sigma.c, block, PointRows<dim>::sigma, p);
  }
};

// Rows: sigma, strain, Omega and one state variable, read and written. Flops: sub-cell sums 36; an elastic law 30; for
// the ledger 16.
constexpr PassCost gather_cost{.flops = 4 + 32, .rows = 1 + 4};
constexpr PassCost stress_cost{.flops = 6 + 20 + 30 + 16 + 9, .rows = 2 * (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(mpm_gp, MpmGp, .title = "MPM-GP",
    .summary = "material points own the history, Gauss points carry force and strain", .gather_cost = gather_cost,
    .stress_cost = stress_cost, TERP_OVERLAP_FUNCTIONS(MpmGp))

}  // namespace terp
