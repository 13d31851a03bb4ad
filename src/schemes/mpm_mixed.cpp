// MPM-Mixed, paper Sec. 2.1: the Gauss points own the history; material points are overwritten every step.
#include "schemes/scheme.hpp"

namespace terp {
namespace {

template <class Element>
struct MpmMixed {
  static constexpr int dim = Element::dim;

  /// Gauss stress, rows of the laws and internal force, Eqs. (1) to (4).
  static void gather(const SchemeContext& context, const CellGroup<Element>& group)
  {
    gather_at_gauss_points(
        context, group, [&](const BlockLayer& layer) -> GaussValues<Element, Pack>& { return group.gauss_of(layer); },
        [&](const BlockLayer& layer, GaussValues<Element, Pack>& gauss) { sum_layer(group, layer, gauss); },
        [&](const BlockLayer& layer, GaussValues<Element, Pack>& gauss, const auto&) {
          GaussRow<Element>* rows = group.rows_of(layer);
          const SoilMaterial& material = context.materials[layer.material];
          for (int k = 0; k < material.n_rows(); ++k) rows[k] = sum_row(group, layer, material.rows[k]);
          divide_rows(gauss, material, rows);
          average_rows(context.method, gauss, material, rows);
        });
  }

  /// Steps 2 to 4 of Sec. 2.1: new stress and state at the Gauss points, assigned to the points of each sub-cell.
  static void update_stress(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums& sums)
  {
    const GaussStrain<Element, Pack> lanes = strain_of_group(group, du, context.method.b_bar);  // Step 2
    const auto strain = strain_by_cell(lanes);
    for_each_layer(group, [&](const BlockLayer& layer) {
      const SoilMaterial& material = context.materials[layer.material];
      GaussValues<Element, Pack>& gauss = group.gauss_of(layer);
      GaussRow<Element>* rows = group.rows_of(layer);
      const Pack plastic_work = update_gauss_points(context, material, lanes, gauss, rows);  // Step 3
      const auto sigma = by_cell(gauss);
      for (int k = 0; k < material.n_state(); ++k) turn_by_cell(rows[k]);
      for (int c = 0; c < group.n(); ++c) {
        if (layer.block[c] < 0) continue;
        prefetch_next(group, c);
        sums.plastic_work += plastic_work[c];
        const PointBlock<dim>& block = group.points.block(layer.block[c]);
        for (Index p = 0; p < block.n; p += pack_width)
          assign_to_points(sigma[c], rows, c, strain[c], material, block, p);  // Step 4
      }
    });
  }

 private:
  /// Means over the sub-cells. A parameter that varies comes as such a mean.
  static void divide_rows(
      const GaussValues<Element, Pack>& gauss, const SoilMaterial& material, GaussRow<Element>* rows)
  {
    const SubCellMeans mean(gauss);
    for (int k = 0; k < material.n_rows(); ++k) mean(rows[k]);
  }

  /// Each state variable says how it is averaged (reading R9).
  static void average_rows(const MethodOptions& method, const GaussValues<Element, Pack>& gauss,
      const SoilMaterial& material, GaussRow<Element>* rows)
  {
    for (int k = 0; k < material.n_state(); ++k)
      if (averages_over_cell(method, material.type->state[k])) average_over_cell(gauss.weight, rows[k]);
  }

  static bool averages_over_cell(const MethodOptions& method, const StateInfo& state)
  {
    if (method.state_averaging == StateAveraging::as_declared) return state.averaging == Averaging::cell;
    return method.state_averaging == StateAveraging::cell;
  }

  /// Runs the law on the Gauss points of eight cells. Returns the plastic work of each cell [J per m].
  static Pack update_gauss_points(const SchemeContext& context, const SoilMaterial& material,
      const GaussStrain<Element, Pack>& strain, GaussValues<Element, Pack>& gauss, GaussRow<Element>* rows)
  {
    if (context.method.objective_rate == ObjectiveRate::jaumann) rotate_gauss_points(strain, gauss);
    constexpr Index n = Element::n_gauss * pack_width;  // numbers of a row
    PerGauss<Element, Pack> plastic_work;
    StressArrays<dim> arrays{};
    for (int k = 0; k < n_sym<dim>; ++k) arrays.sigma[k] = numbers_of(gauss.sigma[k]);
    for (int k = 0; k < n_sym<dim>; ++k) arrays.d_eps[k] = numbers_of(strain.d_eps[k]);
    arrays.law.state = {.data = reinterpret_cast<Real*>(rows), .stride = n};
    arrays.law.parameters = {.data = arrays.law.state(material.n_state()), .stride = n};
    arrays.plastic_work = numbers_of(plastic_work);
    arrays.n = arrays.n_points = n;
    arrays.dt = context.dt;
    material.law->update(arrays);

    Pack work(0.0);
    for (int g = 0; g < Element::n_gauss; ++g) work += plastic_work[g] * gauss.weight[g];
    return work;
  }

  static void rotate_gauss_points(const GaussStrain<Element, Pack>& strain, GaussValues<Element, Pack>& gauss)
  {
    for (int g = 0; g < Element::n_gauss; ++g) {
      SymTensor<Pack, dim> at;
      for (int k = 0; k < n_sym<dim>; ++k) at[k] = gauss.sigma[k][g];
      rotate_stress(at, strain.d_spin[g]);
      for (int k = 0; k < n_sym<dim>; ++k) gauss.sigma[k][g] = at[k];
    }
  }

  using StressOfCell = std::array<PerGauss<Element>, n_sym<dim>>;

  /// Stress cell by cell.
  static std::array<StressOfCell, pack_width> by_cell(const GaussValues<Element, Pack>& lanes)
  {
    std::array<StressOfCell, pack_width> sigma;
    for (int k = 0; k < n_sym<dim>; ++k) from_lanes(lanes.sigma[k], [&](int c) { return sigma[c][k].data(); });
    return sigma;
  }

  /// A row cell by cell, in its own place: the numbers of cell c begin at number n_gauss c.
  static void turn_by_cell(GaussRow<Element>& row)
  {
    const GaussRow<Element> lanes = row;
    from_lanes(lanes, [&](int c) { return numbers_of(row) + Element::n_gauss * c; });
  }

  /// rows: of the law at the Gauss points, turned by cell; c: number of this cell among them.
  static void assign_to_points(const StressOfCell& sigma, const GaussRow<Element>* rows, int c,
      const GaussStrain<Element>& strain, const SoilMaterial& material, const PointBlock<dim>& block, Index p)
  {
    const auto upper = upper_halves<Element>(block, p);
    for (int k = 0; k < n_sym<dim>; ++k)
      Element::at_sub_cell(sigma[k], upper).store(block.row(PointRows<dim>::sigma + k) + p);
    for (int k = 0; k < material.n_state(); ++k) {
      PerGauss<Element> value;
      std::copy_n(numbers_of(rows[k]) + Element::n_gauss * c, Element::n_gauss, value.begin());
      Element::at_sub_cell(value, upper).store(block.row(material.rows[k]) + p);
    }
    scale_volume(block, p, accumulate_strain(block, p, strain_at_points(strain, upper)));
  }
};

// Rows: sigma, Omega and one state variable to gather; then strain and Omega read, and with sigma and state written.
constexpr PassCost gather_cost{.flops = 4 + 40, .rows = 1 + 4 + 1};
constexpr PassCost stress_cost{.flops = 9, .rows = (4 + 1) + (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(mpm_mixed, MpmMixed, .title = "MPM-Mixed",
    .summary = "Gauss points own the history (Martinelli & Galavi 2022)",
    .unused_options = "shares point_pressure pressure_relaxation", .keeps_gauss_values = true,
    .gather_cost = gather_cost, .stress_cost = stress_cost)

}  // namespace terp
