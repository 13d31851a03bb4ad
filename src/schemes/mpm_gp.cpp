// MPM-GP, paper Sec. 2.2: the material points own the history; Gauss points only carry force and strain.
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
    GaussValues<Element, Pack> only;
    const bool one_layer = has_one_layer(group);
    gather_at_gauss_points(
        context, group,
        [&](const BlockLayer& layer) -> GaussValues<Element, Pack>& {
          return one_layer ? only : group.gauss_of(layer);
        },
        [&](const BlockLayer& layer, const GaussValues<Element, Pack>& gauss) {
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
        update_points(context, block, strain[c], group.pressure[b], sums);
      });
    }
  }

 private:
  static void update_points(const SchemeContext& context, const PointBlock<dim>& block,
      const GaussStrain<Element>& strain, Real cell_pressure, StressSums& sums)
  {
    for (Index first = 0; first < block.n_padded(); first += strip_length) {
      const Index n = std::min(strip_length, block.n_padded() - first);
      StripArrays<dim> strip;
      for (Index p = 0; p < n; p += pack_width)
        prepare_points(context.method, block, first + p, strain, cell_pressure, strip, p);
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
    const Real share = method.point_pressure == PointPressure::cell    ? 1.0
                       : method.point_pressure == PointPressure::relax ? method.pressure_relaxation
                                                                       : 0.0;
    add_isotropic(sigma, Pack(share) * (Pack(cell_pressure) - trace(sigma) * Pack(1.0 / 3.0)));
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
    .unused_options = "state_averaging", .gather_cost = gather_cost, .stress_cost = stress_cost)

}  // namespace terp
