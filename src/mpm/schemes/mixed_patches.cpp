// MPM-Mixed over patches of cells. The points take the new Gauss stress with their shares, shifted so that each
// sub-cell keeps the mean deviator of its points, and each block their mean pressure. What is kept turns with the soil.
// Of the state they take what the law added. Values that were handed back as they are would spread without end, even in
// soil that stands still (decision 0042).
#include "mpm/features/patch_rows.hpp"
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/schemes/mixed_law.hpp"

namespace terp {
namespace {

using Upper = decltype(Quad4::upper_halves(Quad4::Local<Pack>{}));

void sum_points(GroupNow& now)
{
  const SchemeContext& context = now.step.context;
  sum_over_patches(context, now.group, patches_of(now.step.work),
      [&](const auto& block) { return std::span<const int>(context.materials[block.material].rows); });
}

void collect_patches(LayerNow& now)
{
  collect_layer(now.at.group, patches_of(now.at.step.work), now.layer, now.gauss, now.rows, now.material.n_rows());
  enter_volume(now);
}

void leave_history(LayerNow& now)
{
  const SoilMaterial& material = now.material;
  LeftRows<Quad4>& left = now.left;
  StressSums& sums = now.at.stress;
  for (int k = 0; k < n_sym<2>; ++k) {
    left.set(HistoryRows::strain + k, now.strain->d_eps[k]);
    left.set(HistoryRows::change + k, now.gauss.sigma[k]);
  }
  for (int k = 0; k < material.n_state(); ++k)
    if (!material.type->state[k].scratch) left.set(HistoryRows::end + k, now.rows[k]);
  const GaussWork work = update_gauss_points(now);
  for (int c = 0; c < now.at.group.n(); ++c)
    if (now.layer.block[c] >= 0) sums.plastic_work += work.plastic[c];
  if (!now.weighed) sums.taken -= where_blocks_are(now.layer, work.plastic_beside);
  for (int k = 0; k < n_sym<2>; ++k) {
    left.set_change(HistoryRows::change + k, now.gauss.sigma[k]);
    left.set(HistoryRows::stress + k, now.gauss.sigma[k]);
  }
  for (int k = 0; k < material.n_state(); ++k) {
    if (material.type->state[k].scratch)
      left.set(HistoryRows::end + k, now.rows[k]);
    else
      left.set_change(HistoryRows::end + k, now.rows[k]);
  }
  if (now.at.step.context.work_row >= 0) left.set(HistoryRows::end + material.n_state(), now.law.plastic_work);
  left.set(HistoryRows::spin, now.strain->d_spin);
  left.end_with(HistoryRows::ratio, HistoryRows::end + material.n_state(), true);
}

/// What the stress of a block's points is above that which the Gauss points had: the pressure as a mean over the
/// block, the deviator over the points of each sub-cell. It enters what that does to their energy.
class KeptStress {
 public:
  KeptStress(const SoilMaterial& material, StressSums& sums)
      : deviator_(repeat<n_sym<2>>(zero_packs<Quad4::n_gauss>())),
        volume_(zero_packs<Quad4::n_gauss>()),
        half_compliance_(material),
        sums_(sums)
  {
  }

  /// Of the points p ... p + 7: their stress, what of it is above that of the Gauss points, and their strain.
  void add(const PointBlock<2>& block, Index p, const SymTensor<Pack, 2>& own, SymTensor<Pack, 2> above,
      const SymTensor<Pack, 2>& d_eps)
  {
    const auto upper = upper_halves<Quad4>(block, p);
    const Pack omega = Pack::load(block.row(PointRows<2>::volume) + p);
    const Pack pressure = trace(above) * Pack(1.0 / 3.0), own_pressure = trace(own) * Pack(1.0 / 3.0);
    sums_.take(own, d_eps, omega);
    const Pack weight = half_compliance_.at(block, p) * omega, around = own_pressure - pressure;
    sums_.reset = fma(weight, (around - own_pressure) * (around + own_pressure), sums_.reset);
    around_ = fma(weight, around, around_);
    weight_ += weight;
    pressure_ = fma(omega, pressure, pressure_);
    add_isotropic(above, -pressure);
    for (int k = 0; k < n_sym<2>; ++k) add_in_sub_cell(omega * above[k], upper, deviator_[k]);
    add_in_sub_cell(omega, upper, volume_);
  }

  /// Adds the means to the points.
  void shift(const PointBlock<2>& block) const
  {
    PerGauss<Quad4> volume;
    for (int g = 0; g < Quad4::n_gauss; ++g) volume[g] = sum(volume_[g]);
    const Real pressure = sum(pressure_) / total(volume);
    sums_.reset += Pack(pressure) * (Pack(2.0) * around_ + Pack(pressure) * weight_);
    std::array<PerGauss<Quad4>, n_sym<2>> mean;
    for (int k = 0; k < n_sym<2>; ++k)
      for (int g = 0; g < Quad4::n_gauss; ++g)
        mean[k][g] = (volume[g] > 0.0 ? sum(deviator_[k][g]) / volume[g] : 0.0) + (k < 3 ? pressure : 0.0);
    for (Index p = 0; p < block.n; p += pack_width) {
      const auto upper = upper_halves<Quad4>(block, p);
      for (int k = 0; k < n_sym<2>; ++k) {
        Real* at = block.row(PointRows<2>::sigma + k) + p;
        (Pack::load(at) + Quad4::at_sub_cell(mean[k], upper)).store(at);
      }
    }
  }

 private:
  static void add_in_sub_cell(Pack value, const Upper& upper, PerGauss<Quad4, Pack>& sums)
  {
    const auto parts = Quad4::in_sub_cell(value, upper);
    for (int g = 0; g < Quad4::n_gauss; ++g) sums[g] += parts[g];
  }

  std::array<PerGauss<Quad4, Pack>, n_sym<2>> deviator_;
  PerGauss<Quad4, Pack> volume_;
  Pack pressure_ = Pack(0.0);
  HalfCompliance half_compliance_;
  Pack around_ = Pack(0.0), weight_ = Pack(0.0);  ///< sums of Omega/2K, and of it times the pressure around
  StressSums& sums_;
};

template <class Shares>
void take_values(BlockNow& now, const Shares& shares, Index p, KeptStress& kept)
{
  const SchemeContext& context = now.context();
  const PointBlock<2>& block = now.block;
  const PatchView& patch = *now.patch;
  const SoilMaterial& material = now.material;
  auto values = patch.at_points<HistoryRows::ratio + 1>(shares, 0);
  const Pack inverse = inverse_ratio(context, values[HistoryRows::ratio]);
  for (Pack& value : values) value = inverse * value;
  const SymTensor<Pack, 2> own = stress_of(block, p);
  SymTensor<Pack, 2> d_eps, above = own;
  for (int k = 0; k < n_sym<2>; ++k) {
    d_eps[k] = values[HistoryRows::strain + k];
    above[k] += values[HistoryRows::change + k] - values[HistoryRows::stress + k];
    values[HistoryRows::stress + k].store(block.row(Rows::sigma + k) + p);
  }
  if (context.method.objective_rate == ObjectiveRate::jaumann)
    rotate_stress(above, inverse * patch.at_points<1>(shares, HistoryRows::spin)[0]);
  kept.add(block, p, own, above, d_eps);
  for (int k = 0; k < material.n_state(); ++k) {
    Real* at = block.row(material.rows[k]) + p;
    const Pack before = material.type->state[k].scratch ? Pack(0.0) : Pack::load(at);
    (before + inverse * patch.at_points<1>(shares, HistoryRows::end + k)[0]).store(at);
  }
  if (context.work_row >= 0)
    patch.at_points<1>(shares, HistoryRows::end + material.n_state())[0].store(block.row(context.work_row) + p);
  scale_volume(block, p, accumulate_strain(block, p, d_eps));
}

void assign_from_patch(BlockNow& now)
{
  KeptStress kept(now.material, now.sums());
  for (Index p = 0; p < now.block.n; p += pack_width)
    with_shares(now.block, p, now.size, [&](const auto& shares) { take_values(now, shares, p, kept); });
  kept.shift(now.block);
}

using P = ScorePlace;

}  // namespace

constinit const Kernel mixed_patches[5] = {
    {P::patch_sums, "points", &sum_points},
    {P::sum, "patches", &collect_patches},
    {P::keep, "rows of the law", &take_means_of_rows},
    {P::gauss_law, "law", &leave_history},
    {P::law, "points", &assign_from_patch},
};

}  // namespace terp
