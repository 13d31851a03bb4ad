// The stable time step against the numbers of the paper's column (reading R19).

#include "forces/time_step.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

constexpr Real bulk = 148e6 / 3.0, shear = 2e6;  // [Pa]

TEST(WaveSpeed, OfThePapersSoilIs161Point65) { EXPECT_NEAR(wave_speed(bulk + 4.0 / 3.0 * shear, 1990.0), 161.65, 0.005); }

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

}  // namespace
}  // namespace terp
