#include "soil/laws/probe.hpp"

namespace newtonian_fluid_test {

Probe fluid(Real bulk, Real viscosity, Real tension_cutoff = 0.0)
{
  return {*find_material("newtonian_fluid"), {bulk, viscosity, tension_cutoff}};
}

TEST(NewtonianFluid, TakesItsShearStressFromTheRate)  // tau = mu gamma', gamma' = 2 eps_xy / dt
{
  Probe point = fluid(2e6, 0.7);
  point.strain({{0.0, 0.0, 0.0, 0.002}});
  EXPECT_NEAR(point.sigma[3], 0.7 * 2.0 * 0.002 / point.dt, 1e-12);
  EXPECT_NEAR(point.plastic_work, 0.7 * std::pow(2.0 * 0.002, 2) / point.dt, 1e-12) << "dissipation mu gamma'^2 dt";
  point.strain(Stress{});
  EXPECT_EQ(point.sigma[3], 0.0) << "no shear stress at rest";
}

TEST(NewtonianFluid, TearsAndGivesNoPressureBeforeItHasClosed)
{
  Probe point = fluid(2e6, 10.0);
  point.sigma = {{-500.0, -500.0, -500.0, 0.0}};
  point.strain({{1e-3, 0.0, 0.0, 1e-3}});
  for (int c = 0; c < 4; ++c) EXPECT_EQ(point.sigma[c], 0.0) << "torn: no stress at all";
  EXPECT_NEAR(point.state[0], 1e-3 - 500.0 / 2e6, 1e-17);
  point.strain({{-5e-4, 0.0, 0.0, 0.0}});
  EXPECT_EQ(trace(point.sigma), 0.0);
  point.strain({{-5e-4, 0.0, 0.0, 0.0}});
  EXPECT_NEAR(trace(point.sigma) / 3.0, -500.0, 1e-9) << "the volume of the start has the pressure of the start";
  EXPECT_EQ(point.state[0], 0.0);
}

TEST(NewtonianFluid, CarriesTheTensionThatItIsAllowed)
{
  Probe some = fluid(2e6, 0.0, 300.0), any = fluid(2e6, 0.0, std::numeric_limits<Real>::infinity());
  for (Probe* point : {&some, &any}) point->strain({{1e-3, 0.0, 0.0, 0.0}});
  EXPECT_NEAR(some.sigma[1], 300.0, 1e-9);
  EXPECT_NEAR(some.state[0], 1e-3 - 300.0 / 2e6, 1e-17);
  EXPECT_NEAR(any.sigma[1], 2000.0, 1e-9);
  EXPECT_EQ(any.state[0], 0.0);
}

// Pressure and opening are linear in the volume, so that means are consistent.
TEST(NewtonianFluid, TornPartsThatMixedAveragesKeepTheirVolume)
{
  Probe torn = fluid(2e6, 0.0), pressed = fluid(2e6, 0.0), mean = fluid(2e6, 0.0);
  torn.strain({{3e-4, 0.0, 0.0, 0.0}});
  pressed.strain({{-5e-4, 0.0, 0.0, 0.0}});
  for (int c = 0; c < 4; ++c) mean.sigma[c] = 0.5 * (torn.sigma[c] + pressed.sigma[c]);
  mean.state[0] = 0.5 * (torn.state[0] + pressed.state[0]);
  mean.strain(Stress{});
  EXPECT_NEAR(mean.sigma[0], -2e6 * 1e-4, 1e-9);
  EXPECT_EQ(mean.state[0], 0.0);
}

TEST(NewtonianFluid, TellsTheTimeStepOfItsViscosity)
{
  EXPECT_EQ(fluid(2e6, 12.0).law().viscosity(), 12.0);
  EXPECT_EQ(fluid(2e6, 12.0).law().p_wave_modulus(), 2e6);
  EXPECT_EQ(find_material("linear_elastic")->make(std::vector<Real>{2e6, 0.3})->viscosity(), 0.0);
}

}  // namespace newtonian_fluid_test
