#include "mpm/kernels/damping.hpp"
#include "support/test.hpp"

namespace damping_test {

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

/// Over many averaging times the mean follows a steady force and passes over one that changes sign in every step.
TEST(Damping, FollowsTheForceOverTheAveragingTime)
{
  const Damping damping{.local = 0.1, .averaging_time = 0.02};
  Vec<2> mean{0.0, 0.0};
  for (int k = 0; k < 20; ++k) follow_force(damping, {50.0, k % 2 == 0 ? 8.0 : -8.0}, 0.001, mean);
  EXPECT_NEAR(mean[0], 50.0 * (1.0 - std::pow(0.95, 20)), 1e-12);
  for (int k = 0; k < 2000; ++k) follow_force(damping, {50.0, k % 2 == 0 ? 8.0 : -8.0}, 0.001, mean);
  EXPECT_NEAR(mean[0], 50.0, 1e-12);
  EXPECT_LT(std::abs(mean[1]), 0.3);  // 8 * 0.05 / 1.95
}

TEST(Damping, AStepLongerThanTheAveragingTimeTakesItsOwnForce)
{
  Vec<2> mean{7.0, -3.0};
  follow_force({.local = 0.1, .averaging_time = 0.02}, {50.0, 8.0}, 0.03, mean);
  EXPECT_EQ(mean, (Vec<2>{50.0, 8.0}));
}

TEST(Damping, ViscousIsProportionalToMassAndVelocity)
{
  EXPECT_DOUBLE_EQ(damping_force({.viscous = 0.5}, 50.0, 3.0, 2.0), -3.0);
  EXPECT_DOUBLE_EQ(damping_force({.viscous = 0.5}, 50.0, 3.0, -2.0), 3.0);
}

TEST(Damping, AddsBothKinds) { EXPECT_DOUBLE_EQ(damping_force({.local = 0.1, .viscous = 0.5}, 50.0, 3.0, 2.0), -8.0); }

TEST(Damping, OfAVectorActsByComponentsAlongAndAcrossGravity)
{
  const Vec<2> straight = damping_force(Damping{.local = 0.1}, Vec<2>{30.0, -50.0}, 3.0, Vec<2>{-1.0, -2.0});
  EXPECT_DOUBLE_EQ(straight[0], 3.0);
  EXPECT_DOUBLE_EQ(straight[1], 5.0);
}

TEST(Damping, TurnsWithGravity)  // everything turned by the angle of the 3-4-5 triangle
{
  const auto turned = [](Vec<2> a) { return Vec<2>{0.8 * a[0] - 0.6 * a[1], 0.6 * a[0] + 0.8 * a[1]}; };
  const Damping tilted{.local = 0.1, .viscous = 0.3, .down = turned({0.0, -1.0})};
  const Vec<2> r{30.0, -50.0}, v{-1.0, 2.0};
  const Vec<2> expected = turned(damping_force({.local = 0.1, .viscous = 0.3}, r, 3.0, v));
  const Vec<2> got = damping_force(tilted, turned(r), 3.0, turned(v));
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(got[d], expected[d], 1e-14);
}

TEST(Damping, IsOffByDefault) { EXPECT_EQ(damping_force({}, 50.0, 3.0, 2.0), 0.0); }

}  // namespace damping_test
