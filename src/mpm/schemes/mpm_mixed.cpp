// MPM-Mixed, paper Sec. 2.1: the Gauss points own the history; material points are overwritten every step.
#include "mpm/schemes/gauss_gather.hpp"
#include "mpm/schemes/patch_rows.hpp"
#include "mpm/schemes/scheme.hpp"

namespace terp {
namespace {

template <class Element>
struct MpmMixed {
  static constexpr int dim = Element::dim;
  using Upper = decltype(Element::upper_halves(typename Element::template Local<Pack>{}));

  /// Gauss stress, rows of the laws and internal force, Eqs. (1) to (4).
  static void gather(const SchemeContext& context, const CellGroup<Element>& group)
  {
    gather_at_gauss_points(
        context, group, [&](const BlockLayer& layer) -> GaussValues<Element, Pack>& { return group.gauss_of(layer); },
        [&](const BlockLayer& layer, GaussValues<Element, Pack>& gauss) { sum_layer(group, layer, gauss); },
        [&](const BlockLayer& layer, GaussValues<Element, Pack>& gauss) {
          GaussRow<Element>* rows = group.rows_of(layer);
          const SoilMaterial& material = context.materials[layer.material];
          for (int k = 0; k < material.n_rows(); ++k) rows[k] = sum_row(group, layer, material.rows[k]);
          divide_rows(gauss, material, rows);
          average_rows(gauss, material, rows);
        });
  }

  /// Steps 2 to 4 of Sec. 2.1: new stress and state at the Gauss points, assigned to the points of each sub-cell.
  static void update_stress(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums& sums)
  {
    GroupVectors<Element> room;
    const GroupVectors<Element>& moved = without_kinks(group, du, room, sums.slip_work);
    const GaussStrain<Element, Pack> lanes = strain_of_group(group, moved, context.method.b_bar);  // Step 2
    const auto strain = strain_by_cell(lanes);
    sums.slip_work += lost_by_slipping(group);
    GaussStrain<Element, Pack> slipped_lanes;
    GaussStrain<Element> slipped;
    for_each_layer(group, [&](const BlockLayer& layer) {
      const SoilMaterial& material = context.materials[layer.material];
      GaussValues<Element, Pack>& gauss = group.gauss_of(layer);
      GaussRow<Element>* rows = group.rows_of(layer);
      GaussRow<Element> plastic_work;
      const GaussStrain<Element, Pack>& own_lanes =
          handed_back(group, layer, with_slips(group, layer, lanes, slipped_lanes), slipped_lanes);
      const GaussWork work =
          update_gauss_points(context, group, layer, own_lanes, {gauss, rows, plastic_work});  // Step 3
      sums.taken += where_blocks_are(layer, work.power - work.plastic_beside);
      const HalfCompliance compliance(material);
      const auto sigma = by_cell(gauss);
      turn_by_cell(plastic_work);
      for (int k = 0; k < material.n_state(); ++k) turn_by_cell(rows[k]);
      for (int c = 0; c < group.n(); ++c) {
        if (layer.block[c] < 0) continue;
        prefetch_next(group, c);
        sums.plastic_work += work.plastic[c];
        const PointBlock<dim>& block = group.points.block(layer.block[c]);
        const Index b = layer.block[c];
        const GaussStrain<Element>& own = handed_back(group, b, with_slip(group, b, strain[c], slipped), slipped);
        update_excess(context, group, b, own, sums);
        for (Index p = 0; p < block.n; p += pack_width) {
          sums.set_pressure(compliance.at(block, p), Pack::load(block.row(PointRows<dim>::volume) + p),
              mean_stress(block, p), gauss.pressure[c]);
          assign_to_points(context, {sigma[c], rows, plastic_work, own, c}, block, p);  // Step 4
        }
        sums.slip_work += lost_while_slipping(group, layer.block[c]);
      }
    });
  }

  /// With shares that overlap, in four passes. The points take the new Gauss stress with their shares, shifted so that
  /// each sub-cell keeps the mean deviator of its points, and each block their mean pressure. What is kept turns with
  /// the soil. Of the state they take what the law added. Values that were handed back as they are would spread without
  /// end, even at rest (decision 0042).
  static void sum_patches(const SchemeContext& context, const CellGroup<Element>& group)
  {
    sum_over_patches(context, group,
        [&](const auto& block) { return std::span<const int>(context.materials[block.material].rows); });
  }

  static void integrate_patches(const SchemeContext& context, const CellGroup<Element>& group)
  {
    gather_at_gauss_points(
        context, group, [&](const BlockLayer& layer) -> GaussValues<Element, Pack>& { return group.gauss_of(layer); },
        [&](const BlockLayer& layer, GaussValues<Element, Pack>& gauss) {
          collect_layer(group, layer, gauss, group.rows_of(layer), context.materials[layer.material].n_rows());
        },
        [&](const BlockLayer& layer, GaussValues<Element, Pack>& gauss) {
          const SoilMaterial& material = context.materials[layer.material];
          divide_rows(gauss, material, group.rows_of(layer));
          average_rows(gauss, material, group.rows_of(layer));
        });
  }

  static void leave_strain(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>& du, StressSums& sums)
  {
    GroupVectors<Element> room;
    const GroupVectors<Element>& moved = without_kinks(group, du, room, sums.slip_work);
    const GaussStrain<Element, Pack> of_cells = strain_of_group(group, moved, context.method.b_bar);  // Step 2
    sums.slip_work += lost_by_slipping(group);
    for_each_layer(group, [&](const BlockLayer& layer) {
      GaussStrain<Element, Pack> slipped;
      const GaussStrain<Element, Pack>& strain = with_slips(group, layer, of_cells, slipped);
      const SoilMaterial& material = context.materials[layer.material];
      GaussValues<Element, Pack>& gauss = group.gauss_of(layer);
      GaussRow<Element>* state = group.rows_of(layer);
      LeftRows<Element> rows;
      for (int k = 0; k < n_sym<dim>; ++k) {
        rows.set(HistoryRows::strain + k, strain.d_eps[k]);
        rows.set(HistoryRows::change + k, gauss.sigma[k]);
      }
      for (int k = 0; k < material.n_state(); ++k)
        if (!material.type->state[k].scratch) rows.set(HistoryRows::end + k, state[k]);
      GaussRow<Element> plastic_work;
      const GaussWork work =
          update_gauss_points(context, group, layer, strain, {gauss, state, plastic_work});  // Step 3
      for (int c = 0; c < group.n(); ++c)
        if (layer.block[c] >= 0) sums.plastic_work += work.plastic[c];
      if (context.method.strain_shares == StrainShares::plain)
        sums.taken -= where_blocks_are(layer, work.plastic_beside);
      for (int k = 0; k < n_sym<dim>; ++k) {
        rows.set_change(HistoryRows::change + k, gauss.sigma[k]);
        rows.set(HistoryRows::stress + k, gauss.sigma[k]);
      }
      for (int k = 0; k < material.n_state(); ++k) {
        if (material.type->state[k].scratch)
          rows.set(HistoryRows::end + k, state[k]);
        else
          rows.set_change(HistoryRows::end + k, state[k]);
      }
      if (context.slip_row >= 0) rows.set(HistoryRows::end + material.n_state(), plastic_work);
      rows.set(HistoryRows::spin, strain.d_spin);
      const int excess = group.excess.empty() ? -1 : group.patches->gauss_width - 1;
      if (excess >= 0) rows.set(excess, layer, group.excess);
      rows.weigh(group, layer, HistoryRows::ratio, HistoryRows::end + material.n_state(), excess);
      rows.leave(group, layer);
    });
  }

  static void update_from_patches(
      const SchemeContext& context, const CellGroup<Element>& group, const GroupVectors<Element>&, StressSums& sums)
  {
    for (int c = 0; c < group.n(); ++c) {
      prefetch_next(group, c);
      const PatchSize size = patch_size(context, group, group.cells[c]);
      for_each_block(group.points, group.cells[c], [&](const PointBlock<dim>& block, Index b) {
        prefetch_for_update(context, block);
        const PatchView patch = view_patch(group, b);
        update_excess_from_patch(context, group, block, size, patch, sums);
        KeptStress kept(context.materials[block.material], sums);
        for (Index p = 0; p < block.n; p += pack_width)
          with_shares(block, p, size,
              [&](const auto& shares) { take_values(context, patch, shares, block, p, kept); });  // Step 4
        kept.shift(block);
        sums.slip_work += lost_while_slipping(group, b);
      });
    }
  }

 private:
  static bool rotates(const SchemeContext& context) { return context.method.objective_rate == ObjectiveRate::jaumann; }

  /// What the stress of a block's points is above that which the Gauss points had: the pressure as a mean over the
  /// block, the deviator over the points of each sub-cell. It enters what that does to their energy.
  class KeptStress {
   public:
    KeptStress(const SoilMaterial& material, StressSums& sums)
        : deviator_(repeat<n_sym<dim>>(zero_packs<Element::n_gauss>())),
          volume_(zero_packs<Element::n_gauss>()),
          half_compliance_(material),
          sums_(sums)
    {
    }

    /// Of the points p ... p + 7: their stress, what of it is above that of the Gauss points, and their strain.
    void add(const PointBlock<dim>& block, Index p, const SymTensor<Pack, dim>& own, SymTensor<Pack, dim> above,
        const SymTensor<Pack, dim>& d_eps)
    {
      const auto upper = upper_halves<Element>(block, p);
      const Pack omega = Pack::load(block.row(PointRows<dim>::volume) + p);
      const Pack pressure = trace(above) * Pack(1.0 / 3.0), own_pressure = trace(own) * Pack(1.0 / 3.0);
      sums_.take(own, d_eps, omega);
      const Pack weight = half_compliance_.at(block, p) * omega, around = own_pressure - pressure;
      sums_.reset = fma(weight, (around - own_pressure) * (around + own_pressure), sums_.reset);
      around_ = fma(weight, around, around_);
      weight_ += weight;
      pressure_ = fma(omega, pressure, pressure_);
      add_isotropic(above, -pressure);
      for (int k = 0; k < n_sym<dim>; ++k) add_in_sub_cell(omega * above[k], upper, deviator_[k]);
      add_in_sub_cell(omega, upper, volume_);
    }

    /// Adds the means to the points.
    void shift(const PointBlock<dim>& block) const
    {
      PerGauss<Element> volume;
      for (int g = 0; g < Element::n_gauss; ++g) volume[g] = sum(volume_[g]);
      const Real pressure = sum(pressure_) / total(volume);
      sums_.reset += Pack(pressure) * (Pack(2.0) * around_ + Pack(pressure) * weight_);
      std::array<PerGauss<Element>, n_sym<dim>> mean;
      for (int k = 0; k < n_sym<dim>; ++k)
        for (int g = 0; g < Element::n_gauss; ++g)
          mean[k][g] = (volume[g] > 0.0 ? sum(deviator_[k][g]) / volume[g] : 0.0) + (k < 3 ? pressure : 0.0);
      for (Index p = 0; p < block.n; p += pack_width) {
        const auto upper = upper_halves<Element>(block, p);
        for (int k = 0; k < n_sym<dim>; ++k) {
          Real* at = block.row(PointRows<dim>::sigma + k) + p;
          (Pack::load(at) + Element::at_sub_cell(mean[k], upper)).store(at);
        }
      }
    }

   private:
    static void add_in_sub_cell(Pack value, const Upper& upper, PerGauss<Element, Pack>& sums)
    {
      const auto parts = Element::in_sub_cell(value, upper);
      for (int g = 0; g < Element::n_gauss; ++g) sums[g] += parts[g];
    }

    std::array<PerGauss<Element, Pack>, n_sym<dim>> deviator_;
    PerGauss<Element, Pack> volume_;
    Pack pressure_ = Pack(0.0);
    HalfCompliance half_compliance_;
    Pack around_ = Pack(0.0), weight_ = Pack(0.0);  ///< sums of Omega/2K, and of it times the pressure around
    StressSums& sums_;
  };

  template <class Shares>
  static void take_values(const SchemeContext& context, const PatchView& patch, const Shares& shares,
      const PointBlock<dim>& block, Index p, KeptStress& kept)
  {
    const SoilMaterial& material = context.materials[block.material];
    auto values = patch.at_points<HistoryRows::ratio + 1>(shares, 0);
    const Pack inverse =
        inverse_ratio(values[HistoryRows::ratio], context.method.strain_shares == StrainShares::transposed);
    for (Pack& value : values) value = inverse * value;
    const SymTensor<Pack, dim> own = stress_of(block, p);
    SymTensor<Pack, dim> d_eps, above = own;
    for (int k = 0; k < n_sym<dim>; ++k) {
      d_eps[k] = values[HistoryRows::strain + k];
      above[k] += values[HistoryRows::change + k] - values[HistoryRows::stress + k];
      values[HistoryRows::stress + k].store(block.row(PointRows<dim>::sigma + k) + p);
    }
    if (rotates(context)) rotate_stress(above, inverse * patch.at_points<1>(shares, HistoryRows::spin)[0]);
    kept.add(block, p, own, above, d_eps);
    for (int k = 0; k < material.n_state(); ++k) {
      Real* at = block.row(material.rows[k]) + p;
      const Pack before = material.type->state[k].scratch ? Pack(0.0) : Pack::load(at);
      (before + inverse * patch.at_points<1>(shares, HistoryRows::end + k)[0]).store(at);
    }
    if (context.slip_row >= 0)
      patch.at_points<1>(shares, HistoryRows::end + material.n_state())[0].store(block.row(context.slip_row) + p);
    scale_volume(block, p, accumulate_strain(block, p, d_eps));
  }

  /// Means over the sub-cells. A parameter that varies comes as such a mean.
  static void divide_rows(
      const GaussValues<Element, Pack>& gauss, const SoilMaterial& material, GaussRow<Element>* rows)
  {
    const SubCellMeans mean(gauss);
    for (int k = 0; k < material.n_rows(); ++k) mean(rows[k]);
  }

  /// Each state variable says how it is averaged (reading R9).
  static void average_rows(
      const GaussValues<Element, Pack>& gauss, const SoilMaterial& material, GaussRow<Element>* rows)
  {
    for (int k = 0; k < material.n_state(); ++k)
      if (material.type->state[k].averaging == Averaging::cell) average_over_cell(gauss.weight, rows[k]);
  }

  /// Of eight cells [J per m].
  struct GaussWork {
    Pack plastic{0.0}, plastic_beside{0.0};  ///< with the weights of the force; by how much more with the volumes
    Pack power{0.0};  ///< of the stress at the start on the strain, with the volumes of the points
  };
  /// What the law changes at the Gauss points of eight cells.
  struct AtGaussPoints {
    GaussValues<Element, Pack>& gauss;
    GaussRow<Element>* rows;          ///< of the law
    GaussRow<Element>& plastic_work;  ///< out: of the step [J/m^3]
  };

  /// Runs the law on the Gauss points of eight cells.
  static GaussWork update_gauss_points(const SchemeContext& context, const CellGroup<Element>& group,
      const BlockLayer& layer, const GaussStrain<Element, Pack>& strain, const AtGaussPoints& at)
  {
    const auto& [gauss, rows, plastic_work] = at;
    const SoilMaterial& material = context.materials[layer.material];
    GaussWork work;
    for (int g = 0; g < Element::n_gauss; ++g) {
      SymTensor<Pack, dim> sigma, d_eps;
      for (int k = 0; k < n_sym<dim>; ++k) sigma[k] = gauss.sigma[k][g], d_eps[k] = strain.d_eps[k][g];
      work.power += gauss.volume[g] * double_dot(sigma, d_eps);
    }
    if (rotates(context)) rotate_gauss_points(strain, gauss);
    constexpr Index n = Element::n_gauss * pack_width;  // numbers of a row
    StressArrays<dim> arrays{};
    for (int k = 0; k < n_sym<dim>; ++k) arrays.sigma[k] = numbers_of(gauss.sigma[k]);
    for (int k = 0; k < n_sym<dim>; ++k) arrays.d_eps[k] = numbers_of(strain.d_eps[k]);
    arrays.law.state = {.data = reinterpret_cast<Real*>(rows), .stride = n};
    arrays.law.parameters = {.data = arrays.law.state(material.n_state()), .stride = n};
    arrays.plastic_work = numbers_of(plastic_work);
    arrays.n = arrays.n_points = n;
    arrays.dt = context.dt;
    PerGauss<Element, Pack> scale;
    if (!material.softening_scale.empty()) {
      alignas(64) Real of_cells[pack_width];
      std::fill_n(of_cells, pack_width, 1.0);
      for (int c = 0; c < group.n(); ++c) of_cells[c] = material.softening_scale[group.cells[c]];
      scale.fill(Pack::load(of_cells));
      arrays.softening_scale = numbers_of(scale);
    }
    if (material.type->looks_around)
      update_with_surroundings(context, group, layer, strain, arrays);
    else
      material.law->update(arrays);

    const bool takes_over = context.inverse_extent < 0 && !group.ratios.empty();
    const PerGauss<Element, Pack> weight = takes_over ? weights_taken(gauss) : gauss.weight;
    for (int g = 0; g < Element::n_gauss; ++g) {
      work.plastic += plastic_work[g] * weight[g];
      work.plastic_beside += plastic_work[g] * (gauss.volume[g] - weight[g]);
    }
    return work;
  }

  /// Runs a law that looks around: lanes whose cell has no such soil are marked.
  static void update_with_surroundings(const SchemeContext& context, const CellGroup<Element>& group,
      const BlockLayer& layer, const GaussStrain<Element, Pack>& strain, StressArrays<dim> arrays)
  {
    std::array<Index, pack_width> cells;
    std::array<Real, pack_width> sizes{};
    alignas(64) Real x[dim][Element::n_gauss * pack_width] = {};
    cells.fill(-1);
    for (int c = 0; c < group.n(); ++c) {
      if (layer.block[c] < 0) continue;
      cells[c] = group.cells[c];
      sizes[c] = std::sqrt(group.mesh.geometry(cells[c]).volume);
      for (int g = 0; g < Element::n_gauss; ++g) {
        const auto N = Element::shape_functions(Element::gauss_place(g));
        for (int d = 0; d < dim; ++d)
          for (int i = 0; i < Element::n_corners; ++i)
            x[d][g * pack_width + c] += N[i] * group.mesh.nodes[group.mesh.cells[cells[c]][i]][d];
      }
    }
    Surroundings<dim> around{.time = context.time,
        .step = context.step,
        .cells = cells,
        .cell_sizes = sizes,
        .d_spin = numbers_of(strain.d_spin),
        .turned = rotates(context)};
    for (int d = 0; d < dim; ++d) around.x[d] = x[d];
    arrays.around = &around;
    context.materials[layer.material].law->update(arrays);
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

  /// What the points of a cell take; its rows have those of all cells of the group, turned by cell.
  struct OfCell {
    const StressOfCell& sigma;
    const GaussRow<Element>* rows;          ///< of the law
    const GaussRow<Element>& plastic_work;  ///< of the step [J/m^3]
    const GaussStrain<Element>& strain;
    int number;  ///< of the cell in its group
  };

  static void assign_to_points(const SchemeContext& context, const OfCell& cell, const PointBlock<dim>& block, Index p)
  {
    const SoilMaterial& material = context.materials[block.material];
    const auto upper = upper_halves<Element>(block, p);
    const auto assign = [&](const GaussRow<Element>& row, int to) {
      PerGauss<Element> value;
      std::copy_n(numbers_of(row) + Element::n_gauss * cell.number, Element::n_gauss, value.begin());
      Element::at_sub_cell(value, upper).store(block.row(to) + p);
    };
    for (int k = 0; k < n_sym<dim>; ++k)
      Element::at_sub_cell(cell.sigma[k], upper).store(block.row(PointRows<dim>::sigma + k) + p);
    for (int k = 0; k < material.n_state(); ++k) assign(cell.rows[k], material.rows[k]);
    if (context.slip_row >= 0) assign(cell.plastic_work, context.slip_row);
    scale_volume(block, p, accumulate_strain(block, p, strain_at_points(cell.strain, upper)));
  }
};

// Rows: sigma, Omega and one state variable to gather; then strain, sigma and Omega read, and with state written.
// Flops: for the ledger 9.
constexpr PassCost gather_cost{.flops = 4 + 40, .rows = 1 + 4 + 1};
constexpr PassCost stress_cost{.flops = 9 + 9, .rows = (4 + 3 + 1) + (4 + 4 + 1 + 1)};

}  // namespace

TERP_SCHEME_DEFINITION(mpm_mixed, MpmMixed, .title = "MPM-Mixed",
    .summary = "Gauss points own the history (Martinelli & Galavi 2022)",
    .with_overlap =
        "points add to their own history what the law adds at the Gauss points: none loses strength to "
        "its neighbours, and none regains any",
    .keeps_gauss_values = true, .gather_cost = gather_cost, .stress_cost = stress_cost,
    TERP_OVERLAP_FUNCTIONS(MpmMixed))

}  // namespace terp
