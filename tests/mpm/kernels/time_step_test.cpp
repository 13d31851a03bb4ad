// The stable time step against the numbers of the paper's column (reading R19).
#include "mpm/kernels/time_step.hpp"
#include "support/test.hpp"

namespace time_step_test {

constexpr Real bulk = 148e6 / 3.0, shear = 2e6;  // [Pa]

TEST(WaveSpeed, OfThePapersSoilIs161Point65)
{
  EXPECT_NEAR(wave_speed(bulk + 4.0 / 3.0 * shear, 1990.0), 161.65, 0.005);
}

TEST(StableTimeStep, IsThatOfThePapersColumn)
{
  const Real dt = stable_time_step(0.98, 0.1, wave_speed(bulk + 4.0 / 3.0 * shear, 1990.0));
  EXPECT_NEAR(dt, 6.06e-4, 0.005e-4);
  EXPECT_EQ(std::ceil(4.0 / dt), 6598.0) << "steps in 4 s";
}

TEST(StableTimeStep, GrowsWithTheCellAndFallsWithTheWave)
{
  EXPECT_DOUBLE_EQ(stable_time_step(0.5, 0.3, 100.0), 1.5e-3);
  EXPECT_DOUBLE_EQ(stable_time_step(0.5, 0.6, 200.0), 1.5e-3);
}

TEST(ViscousReduction, IsOneWithoutViscosity) { EXPECT_EQ(viscous_reduction(0.0, 0.1, 20.0), 1.0); }

TEST(ViscousReduction, LeavesTheLimitOfDiffusionWhereViscosityRules)  // dt = L^2 / (2 4/3 nu)
{
  const Real nu = 1e4, altitude = 0.1, wave = 20.0;
  EXPECT_NEAR(stable_time_step(1.0, altitude, wave) * viscous_reduction(nu, altitude, wave),
      altitude * altitude / (8.0 / 3.0 * nu), 1e-12);
}

TEST(ViscousReduction, IsWhereTheDampedOscillatorOfTheShortestWaveTurnsUnstable)
{
  const Real nu = 0.4, altitude = 0.1, wave = 20.0, w = 2.0 * wave / altitude, z = 4.0 * nu / (3.0 * wave * altitude);
  const auto grows = [&](Real dt) {  // leapfrog with the viscous force of the old velocity
    Real x = 1.0, v = 0.0, largest = 0.0;
    for (int k = 0; k < 20000; ++k) {
      v += dt * (-w * w * x - 2.0 * z * w * v);
      x += dt * v;
      largest = std::max(largest, std::abs(x));
    }
    return largest > 10.0;
  };
  const Real limit = stable_time_step(1.0, altitude, wave) * viscous_reduction(nu, altitude, wave);
  EXPECT_FALSE(grows(0.999 * limit));
  EXPECT_TRUE(grows(1.001 * limit));
}

}  // namespace time_step_test
