// Standard MPM: force and strain at the material points, with B at the point. The baseline: it locks and oscillates.
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/schemes/excess_pressure.hpp"
#include "mpm/schemes/scheme.hpp"

namespace terp {
namespace {

template <class Element>
struct StandardMpm {
  static constexpr int dim = Element::dim;

  static void gather(const SchemeContext& context, const CellGroup<Element>& group)
  {
    for (int c = 0; c < group.n(); ++c)
      for_each_block(group.points, group.cells[c], [&](const PointBlock<dim>& block, Index) {
        const CellGeometry<Element>& geometry = group.mesh.geometry(group.cells[c]);
        add_internal_force_of_points(geometry, block, group.corners[c]);
        const SoilMaterial& material = context.materials[block.material];
        if (context.pore != nullptr)
          add_pore_force_of_points(geometry, block,
              pore_at_corners<Element>(*context.pore, group.mesh.cells[group.cells[c]], material.stores_effective),
              material.is_drained() ? material.density : 0.0, group.water_force[c]);
        if (material.excess_row >= 0) add_excess_force(context, group, c, block);
      });
  }

  static void update_stress(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums& sums)
  {
    for (int c = 0; c < group.n(); ++c) {
      prefetch_next(group, c);
      for_each_block(group.points, group.cells[c], [&](const PointBlock<dim>& block, Index) {
        update_points(context, group.mesh.geometry(group.cells[c]), du[c], block, sums);
      });
    }
  }

 private:
  /// What soil stores is part of its internal force.
  static void add_excess_force(
      const SchemeContext& context, const CellGroup<Element>& group, int c, const PointBlock<dim>& block)
  {
    const SoilMaterial& material = context.materials[block.material];
    CornerVectors<Element> force{};
    add_excess_force_of_points(group.mesh.geometry(group.cells[c]), block, material.excess_row, force);
    const bool stored = stores_excess(context, material);
    CornerVectors<Element>& sums = stored ? group.corners[c].internal_force : group.water_force[c];
    for (int d = 0; d < dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) sums[d][i] += stored ? -force[d][i] : force[d][i];
  }

  static void update_points(const SchemeContext& context, const CellGeometry<Element>& cell,
      const CornerVectors<Element>& du, const PointBlock<dim>& block, StressSums& sums)
  {
    for (Index first = 0; first < block.n_padded(); first += strip_length) {
      const Index n = std::min(strip_length, block.n_padded() - first);
      StripArrays<dim> strip;
      for (Index p = 0; p < n; p += pack_width)
        prepare_points(context.method, cell, du, block, first + p, strip, p, sums);
      if (looks_around(context, block.material))
        for (Index p = 0; p < n; p += pack_width) spin_of_points(cell, du, block, first + p).store(strip.d_spin + p);
      update_excess(context, block, first, n, strip, sums);
      update_strip(context, block, first, n, strip);
      sums.plastic_work += sum_plastic_work(block, first, n, strip);
      for (Index p = 0; p < n; p += pack_width) add_strain(block, first + p, strip, p);
    }
  }

  static void update_excess(const SchemeContext& context, const PointBlock<dim>& block, Index first, Index n,
      const StripArrays<dim>& strip, StressSums& sums)
  {
    const SoilMaterial& material = context.materials[block.material];
    if (material.excess_row < 0) return;
    const ExcessStep step(context, material);
    for (Index p = 0; p < n; p += pack_width) {
      Real* at = block.row(material.excess_row) + first + p;
      Pack volumetric(0.0);
      for (int k = 0; k < 3; ++k) volumetric += Pack::load(strip.d_eps[k] + p);
      const Pack own = Pack::load(at);
      step(own, own, volumetric, Pack::load(block.row(PointRows<dim>::volume) + first + p), sums).store(at);
    }
  }

  static void prepare_points(const MethodOptions& method, const CellGeometry<Element>& cell,
      const CornerVectors<Element>& du, const PointBlock<dim>& block, Index p, StripArrays<dim>& strip, Index at,
      StressSums& sums)
  {
    using Rows = PointRows<dim>;
    const auto gradient = gradients_at(cell, load_rows<dim>(block, Rows::xi, p));
    const auto l = displacement_gradient(gradient, du);
    const SymTensor<Pack, dim> d_eps = symmetric_part(l);
    store_strain(d_eps, strip, at);
    SymTensor<Pack, dim> sigma = stress_of(block, p);
    sums.take(sigma, d_eps, Pack::load(block.row(Rows::volume) + p));
    if (method.objective_rate == ObjectiveRate::none) return;

    rotate_stress(sigma, (l[1][0] - l[0][1]) * Pack(0.5));
    store_rows(sigma.c, block, Rows::sigma, p);
  }

  static Pack spin_of_points(
      const CellGeometry<Element>& cell, const CornerVectors<Element>& du, const PointBlock<dim>& block, Index p)
  {
    const auto l = displacement_gradient(gradients_at(cell, load_rows<dim>(block, PointRows<dim>::xi, p)), du);
    return (l[1][0] - l[0][1]) * Pack(0.5);
  }
};

// Rows: sigma, strain, Omega and one state variable, read and written. Flops: gradients 44, force or strain 28; an
// elastic law 30; for the ledger 10.
constexpr PassCost gather_cost{.flops = 3 + 44 + 28, .rows = 1 + 4};
constexpr PassCost stress_cost{.flops = 44 + 28 + 20 + 30 + 10 + 9, .rows = 2 * (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(standard_mpm, StandardMpm, .title = "standard MPM",
    .summary = "points carry strain and force; the baseline, which locks and oscillates",
    .unused_options = "as shares weights filled_fraction b_bar cut_cells strain_shares volume_change pressure",
    .locks = true, .gather_cost = gather_cost, .stress_cost = stress_cost)

}  // namespace terp
