#include "user_laws/law_cost.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace terp {

LawCost time_law(const SoilMaterial& material, const PointBlock<2>& block, Real cell_size, Real dt)
{
  using Rows = PointRows<2>;
  constexpr double long_enough = 0.02;  // [s]
  constexpr Real shear_strain = 1e-6;
  const Index n = block.n_padded();
  const auto copy_of = [&](int row) { return std::vector<Real>(block.row(row), block.row(row) + n); };
  std::array<std::vector<Real>, n_sym<2>> sigma;
  std::vector<Real> state, none(n), shear(n, shear_strain), work(n);
  for (int k = 0; k < n_sym<2>; ++k) sigma[k] = copy_of(Rows::sigma + k);
  for (int k = 0; k < material.n_state(); ++k) {
    const std::vector<Real> row = copy_of(material.rows[k]);
    state.insert(state.end(), row.begin(), row.end());
  }
  const Surroundings<2> around{.cells = {&block.cell, 1},
      .cell_sizes = {&cell_size, 1},
      .x = {block.row(Rows::x), block.row(Rows::x + 1)},
      .d_spin = none.data(),
      .id = block.row(Rows::id)};
  StressArrays<2> arrays{};
  for (int k = 0; k < n_sym<2>; ++k) arrays.sigma[k] = sigma[k].data();
  arrays.d_eps = {none.data(), none.data(), none.data(), shear.data()};
  arrays.law.state = {.data = state.data(), .stride = n};
  arrays.plastic_work = work.data();
  arrays.n = n;
  arrays.n_points = block.n;
  arrays.dt = dt;
  arrays.around = &around;

  using Clock = std::chrono::steady_clock;
  const auto stress_before = sigma;
  const auto state_before = state;
  std::int64_t calls = 0;
  double seconds = 0.0;
  while (seconds < long_enough && material.law->fault().empty()) {
    for (int k = 0; k < n_sym<2>; ++k) std::ranges::copy(stress_before[k], sigma[k].begin());
    std::ranges::copy(state_before, state.begin());
    const auto start = Clock::now();
    material.law->update(arrays);
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
    ++calls;
  }
  return {seconds / static_cast<double>(std::max<std::int64_t>(1, calls) * std::max<Index>(1, block.n)),
      material.law->fault()};
}

}  // namespace terp
