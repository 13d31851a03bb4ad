// Damping: against the motion, as large as its share of the out-of-balance force, none at rest.

#include "forces/damping.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

TEST(Damping, LocalDampingTakesItsShareAgainstTheMotion)
{
  const Damping damping{.local = 0.1};
  EXPECT_DOUBLE_EQ(damping_force(damping, 50.0, 3.0, 2.0), -5.0);
  EXPECT_DOUBLE_EQ(damping_force(damping, -50.0, 3.0, 2.0), -5.0);
  EXPECT_DOUBLE_EQ(damping_force(damping, 50.0, 3.0, -2.0), 5.0);
  EXPECT_DOUBLE_EQ(damping_force(damping, -50.0, 3.0, -1e-30), 5.0);
}

TEST(Damping, LocalLetsAFallingBodySeeNineTenthsOfGravity)
{
  const Real m = 7.0, weight = -9.81 * m;
  EXPECT_DOUBLE_EQ((weight + damping_force({.local = 0.1}, weight, m, -3.0)) / m, -0.9 * 9.81);
}

TEST(Damping, NothingDampsANodeAtRest)
{
  EXPECT_EQ(damping_force({.local = 0.7}, 50.0, 3.0, 0.0), 0.0);
  EXPECT_EQ(damping_force({.local = 0.7, .viscous = 0.5}, 50.0, 3.0, -0.0), 0.0);
}

TEST(Damping, ViscousIsProportionalToMassAndVelocity)
{
  EXPECT_DOUBLE_EQ(damping_force({.viscous = 0.5}, 50.0, 3.0, 2.0), -3.0);
  EXPECT_DOUBLE_EQ(damping_force({.viscous = 0.5}, 50.0, 3.0, -2.0), 3.0);
}

TEST(Damping, AddsBothKinds) { EXPECT_DOUBLE_EQ(damping_force({.local = 0.1, .viscous = 0.5}, 50.0, 3.0, 2.0), -8.0); }

TEST(Damping, IsOffByDefault) { EXPECT_EQ(damping_force({}, 50.0, 3.0, 2.0), 0.0); }

}  // namespace
}  // namespace terp
