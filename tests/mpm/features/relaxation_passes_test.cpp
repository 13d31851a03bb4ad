// Velocities that the mesh does not see fade; those that it sees stay (decision 0048).
#include "support/simulations.hpp"

namespace relaxation_passes_test {

/// A block in flight without gravity or sides, whose points relax at once.
Simulation flying(const std::string& scheme, Real relaxation_time)
{
  Case c = free_box(scheme, {1.0, 0.5}, {3.0, 2.0}, elastic(2e6, 0.3, 2000.0));
  c.method.relaxation_time = relaxation_time;
  return Simulation(c);
}

/// 1/2 sum m |v - w(x)|^2 [J per m].
template <class Field>
Real energy_beside(const State& state, Field w)
{
  Real energy = 0.0;
  for (const Point& p : points_by_id(state))
    for (int d = 0; d < 2; ++d) energy += 0.5 * p.mass * std::pow(p.v[d] - w(p.x)[d], 2);
  return energy;
}

Vec<2> nothing(Vec<2>) { return {0.0, 0.0}; }

/// Neighbouring points against each other: the nodes hardly move.
void shake(State& state)
{
  edit_points(state, [](const PointBlock<2>& block, Index lane) {
    block.row(Rows::v)[lane] = lane % 2 == 0 ? 1.0 : -1.0;
    block.row(Rows::v + 1)[lane] = lane % 3 == 0 ? -0.5 : 0.25;
  });
}

TEST(RelaxationPasses, WhatPointsMoveAgainstEachOtherFades)
{
  Simulation s = flying("mpm_gp", 1e-9), kept = flying("mpm_gp", 0.0);
  for (Simulation* each : {&s, &kept}) shake(each->state);
  const Vec<2> before = momentum(s.state);
  const Real start = energy_beside(s.state, nothing);
  s.step();
  kept.step();
  EXPECT_LT(energy_beside(s.state, nothing), 0.1 * start);
  EXPECT_GT(energy_beside(kept.state, nothing), 0.9 * start);
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(momentum(s.state)[d], before[d], 1e-9 * std::sqrt(start));
  EXPECT_NEAR(
      s.state.work.relaxation, energy_beside(s.state, nothing) - energy_beside(kept.state, nothing), 1e-9 * start);
  EXPECT_EQ(kept.state.work.relaxation, 0.0);
}

TEST(RelaxationPasses, AVelocityThatTheMeshCarriesStays)
{
  const auto stretch = [](Vec<2> x) { return Vec<2>{0.3 - 0.2 * x[0] + 0.1 * x[1], 0.1 * x[0] + 0.05 * x[1]}; };
  Simulation s = flying("mpm_gp", 1e-9), kept = flying("mpm_gp", 0.0);
  for (Simulation* each : {&s, &kept})
    edit_points(each->state, [&](const PointBlock<2>& block, Index lane) {
      const Vec<2> v = stretch({block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]});
      for (int d = 0; d < 2; ++d) block.row(Rows::v + d)[lane] = v[d];
    });
  const Real start = energy_beside(s.state, nothing);
  s.step();
  kept.step();
  const auto of_kept = points_by_id(kept.state), of_s = points_by_id(s.state);
  Real change = 0.0;
  for (std::size_t p = 0; p < of_s.size(); ++p)
    for (int d = 0; d < 2; ++d) change += 0.5 * of_s[p].mass * std::pow(of_s[p].v[d] - of_kept[p].v[d], 2);
  EXPECT_LT(change, 1e-5 * start);  // what the pull towards the nodes takes
}

TEST(RelaxationPasses, FadesWithItsTimeConstantWhateverTheStep)
{
  const Real time = 40.0 * flying("standard_mpm", 0.0).model.dt;
  const auto left_after = [&](Real relaxation_time) {
    Simulation each = flying("standard_mpm", relaxation_time);
    shake(each.state);
    const Real start = energy_beside(each.state, nothing);
    each.step(40);
    return energy_beside(each.state, nothing) / start;
  };
  EXPECT_NEAR(left_after(time), std::exp(-2.0), 0.03);
  EXPECT_NEAR(left_after(0.5 * time), std::exp(-4.0), 0.03);
}

}  // namespace relaxation_passes_test
