// What a law may change points into copies that this object owns, and is set up once; therefore it cannot be copied. A
// call overwrites the copies, so calls in sequence go on from each other until they are prepared again.

#include "model/libraries/law_trial.hpp"

#include <algorithm>

namespace terp {

LawTrial::LawTrial(const SoilMaterial& material, const PointBlock<2>& block, Real cell_size, Real dt)
    : material_(material), cell_(block.cell), cell_size_(cell_size)
{
  using PointRow = PointRows<2>;
  const Index n = block.n_padded();
  const auto copy_of = [&](int row) { return std::vector<Real>(block.row(row), block.row(row) + n); };
  for (int k = 0; k < n_sym<2>; ++k) sigma_before_[k] = copy_of(PointRow::sigma + k);
  for (int k = 0; k < material.n_state(); ++k) {
    const std::vector<Real> row = copy_of(material.rows[k]);
    state_before_.insert(state_before_.end(), row.begin(), row.end());
  }
  none_.assign(n, 0.0);
  work_.assign(n, 0.0);
  sigma_ = sigma_before_, state_ = state_before_;
  d_eps_.fill(none_);
  around_ = {.cells = {&cell_, 1},
      .cell_sizes = {&cell_size_, 1},
      .x = {block.row(PointRow::x), block.row(PointRow::x + 1)},
      .d_spin = none_.data(),
      .id = block.row(PointRow::id)};
  for (int k = 0; k < n_sym<2>; ++k) arrays_.sigma[k] = sigma_[k].data(), arrays_.d_eps[k] = d_eps_[k].data();
  arrays_.law.state = {.data = state_.data(), .stride = n};
  arrays_.plastic_work = work_.data();
  arrays_.n = n;
  arrays_.n_points = block.n;
  arrays_.dt = dt;
  arrays_.around = &around_;
}

void LawTrial::prepare(const std::array<Real, 4>& d_eps)
{
  for (int k = 0; k < n_sym<2>; ++k) {
    std::ranges::copy(sigma_before_[k], sigma_[k].begin());
    std::ranges::fill(d_eps_[k], d_eps[k]);
  }
  std::ranges::copy(state_before_, state_.begin());
}

void LawTrial::call() { material_.law->update(arrays_); }

std::vector<Real> LawTrial::stress_and_state() const
{
  std::vector<Real> all;
  for (const std::vector<Real>& row : sigma_) all.insert(all.end(), row.begin(), row.end());
  all.insert(all.end(), state_.begin(), state_.end());
  return all;
}

std::array<Real, 4> LawTrial::stress_change(Index lane) const
{
  std::array<Real, 4> change;
  for (int k = 0; k < n_sym<2>; ++k) change[k] = sigma_[k][lane] - sigma_before_[k][lane];
  return change;
}

}  // namespace terp
