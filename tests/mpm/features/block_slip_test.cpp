#include "mpm/features/slip.hpp"
#include "mpm/features/block_slip.hpp"

#include "mpm/step/workspace.hpp"
#include "support/simulations.hpp"
#include "support/two_soils.hpp"

namespace block_slip_test {

/// Makes a step of two clays with this stress in the lower and the upper one, as xx, yy, zz, xy [Pa], and this plastic
/// work in the step before [J/m^3].
std::unique_ptr<Simulation> after_a_step(
    Real degrees, std::array<std::array<Real, 4>, 2> sigma, std::array<Real, 2> plastic_work)
{
  Model model = build_model(two_clays("mpm_gp", Shares::point, {2.6, 2.4}, degrees), 1);
  model.dt = 1.0e-15;
  State state = build_state(model);
  auto run = std::make_unique<Simulation>(std::move(model), std::move(state));
  Simulation& s = *run;
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    const auto soil = static_cast<std::size_t>(block.material);
    for (int k = 0; k < 4; ++k) block.row(Rows::sigma + k)[lane] = sigma[soil][static_cast<std::size_t>(k)];
    block.row(s.model.with.slip->row)[lane] = plastic_work[soil];
  });
  make_steps(s);
  return run;
}

/// Calls f(first block, second block) for the cells of two soils.
template <class F>
void for_each_cut_cell(const Simulation& s, F&& f)
{
  int n = 0;
  for (const Index cell : s.state.points.occupied()) {
    const Index b = s.state.points.first_block(cell);
    if (s.state.points.block(b).next < 0) continue;
    f(b, s.state.points.block(b).next);
    ++n;
  }
  EXPECT_GT(n, 8);
}

constexpr std::array<std::array<Real, 4>, 2> weak_and_strong{
    {{-5e3, -5e3, -5e3, 2e3}, {-5e3, -5e3, -5e3, 6e3}}};  // under shear along a level border

TEST(CutCells, SlipOnlyAfterPlasticWorkAboveRoundOff)
{
  for (const auto& [work, slips] : {std::pair{0.0, false}, std::pair{1e-17, false}, std::pair{1e-9, true}}) {
    const auto run_s = after_a_step(20.0, weak_and_strong, {0.0, work});
    const Simulation& s = *run_s;  // J/m^3; sigma : sigma/G is 5
    for_each_cut_cell(s, [&](Index first, Index second) {
      EXPECT_EQ(s.work.with.slip->blocks[first].acts(), slips) << work;
      EXPECT_EQ(s.work.with.slip->blocks[second].acts(), slips) << work;
    });
  }
}

/// The kinks of the cells of the level border, away from the ends of the upper body.
void expect_kinks(const Simulation& s, Real slipped)
{
  int n = 0;
  for (const Index cell : s.state.points.occupied()) {
    const Vec<2>& at = s.model.mesh->centres[cell];
    if (std::abs(at[0] - 2.6) > 1.0 || std::abs(at[1] - 2.4) > 0.125) continue;
    const BlockSlip& first = s.work.with.slip->blocks[s.state.points.first_block(cell)];
    EXPECT_TRUE(first.acts());
    EXPECT_NEAR(first.kink.slipped, slipped, 1e-9);
    ++n;
  }
  EXPECT_GT(n, 5);
}

TEST(CutCells, HaveAKinkOnlyWhereTheSoilOfLessShearYieldedAndBothShearAlike)
{
  expect_kinks(*after_a_step(0.0, weak_and_strong, {1.0, 0.0}), 4e3 / soft);
  expect_kinks(*after_a_step(0.0, weak_and_strong, {0.0, 1.0}), 0.0);
  auto sigma = weak_and_strong;
  sigma[0][3] = -2e3;
  expect_kinks(*after_a_step(0.0, sigma, {1.0, 1.0}), 0.0);
  sigma[1][3] = -6e3;
  expect_kinks(*after_a_step(0.0, sigma, {1.0, 0.0}), -4e3 / soft);
}

TEST(CutCells, GiveBackByAKinkNoMoreThanTheirPlasticWork)
{
  int n_bounded = 0, n_free = 0;
  for (const Real along : {-4e4, 4e4}) {
    auto sigma = weak_and_strong;
    for (auto& of_soil : sigma) of_soil[0] += along;
    const auto run_s = after_a_step(30.0, sigma, {1e-3, 0.0});
    const Simulation& s = *run_s;
    for_each_cut_cell(s, [&](Index first, Index second) {
      const Kink& kink = s.work.with.slip->blocks[first].kink;
      if (kink.slipped == 0.0) return;
      Real lost = kink.force, plastic_work = 0.0;
      std::array<Real, 2> tau{};
      for (const Index b : {first, second}) {
        const BlockSlip& slip = s.work.with.slip->blocks[b];
        const auto soil = static_cast<std::size_t>(s.state.points.block(b).material);
        tau[soil] = slip.normal * (slip.sigma[0] - slip.sigma[1]) + 2.0 * slip.shear * slip.sigma[3];
        lost -= kink.share * slip.weight * tau[soil];
        if (soil == 0) plastic_work = 1e-3 * slip.weight;
      }
      const Real slipped = (tau[1] - tau[0]) / soft;
      if (slipped * lost < -plastic_work) {
        EXPECT_NEAR(kink.slipped * lost, -plastic_work, 1e-6 * plastic_work);
        ++n_bounded;
      } else {
        EXPECT_NEAR(kink.slipped, slipped, 1e-9 * std::abs(slipped));
        ++n_free;
      }
    });
  }
  EXPECT_GT(n_bounded, 3);
  EXPECT_GT(n_free, 3);
}

}  // namespace block_slip_test
