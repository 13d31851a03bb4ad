#include "mpm/features/footing.hpp"
#include "support/test.hpp"

namespace footing_test {

Footing footing()
{
  return {.name = "pile", .low = {1.0, 2.0}, .high = {3.0, 2.5}, .velocity = {0.3, -0.4}, .ramp = 0.2, .rough = true};
}

/// v(t) = V (1 - cos(pi t/T))/2, summed by the midpoint rule [m].
Real summed_way(Real velocity, Real ramp, Real time)
{
  constexpr int n = 20000;
  Real way = 0.0;
  for (int k = 0; k < n; ++k) {
    const Real t = (k + 0.5) * time / n;
    way += velocity * (t < ramp ? 0.5 * (1.0 - std::cos(std::numbers::pi * t / ramp)) : 1.0) * time / n;
  }
  return way;
}

TEST(Footing, ComesAsFarAsItsVelocityLeads)
{
  for (const Real time : {0.05, 0.13, 0.2, 0.7})
    EXPECT_THAT(footing().displacement(time),
        ElementsAre(DoubleNear(summed_way(0.3, 0.2, time), 1e-9), DoubleNear(summed_way(-0.4, 0.2, time), 1e-9)));
}

TEST(Footing, WithoutARampMovesFromTheStart)
{
  Footing f = footing();
  f.ramp = 0.0;
  EXPECT_THAT(f.displacement(0.5), ElementsAre(0.15, -0.2));
  EXPECT_THAT(f.displacement(0.0), ElementsAre(0.0, 0.0));
}

TEST(PlacedFooting, StepsAddUpToTheWay)
{
  const Real dt = 0.007;
  Vec<2> way{0.0, 0.0};
  for (int k = 0; k < 100; ++k) {
    const PlacedFooting placed = place_footing(footing(), k * dt, dt, 0.0);
    EXPECT_NEAR(placed.low[0], 1.0 + way[0], 1e-14);
    EXPECT_NEAR(placed.high[1], 2.5 + way[1], 1e-14);
    for (int d = 0; d < 2; ++d) way[d] += placed.velocity[d] * dt;
  }
  EXPECT_NEAR(way[1], footing().displacement(0.7)[1], 1e-14);
}

TEST(PlacedFooting, HoldsWhatLiesInItAndOnItsOutline)
{
  const PlacedFooting placed = place_footing(footing(), 0.0, 0.01, 1e-7);
  EXPECT_TRUE(placed.holds({2.0, 2.2}));
  EXPECT_TRUE(placed.holds({1.0, 2.0}));
  EXPECT_TRUE(placed.holds({3.0 + 5e-8, 2.5}));
  EXPECT_FALSE(placed.holds({3.0 + 2e-7, 2.5}));
  EXPECT_FALSE(placed.holds({2.0, 1.9}));
}

TEST(PlacedFooting, RoughTakesBothComponents)
{
  const PlacedFooting placed = place_footing(footing(), 1.0, 0.01, 0.0);
  Vec<2> v{5.0, 7.0};
  placed.hold(v);
  EXPECT_THAT(v, ElementsAre(DoubleNear(0.3, 1e-13), DoubleNear(-0.4, 1e-13)));
  EXPECT_THAT(placed.free_part({5.0, 7.0}), ElementsAre(0.0, 0.0));
}

TEST(PlacedFooting, SmoothTakesTheComponentAlongItsMotion)
{
  Footing f = footing();
  f.rough = false;
  const PlacedFooting placed = place_footing(f, 1.0, 0.01, 0.0);  // along (0.6, -0.8), 0.5 m/s
  Vec<2> v{5.0, 7.0};                                             // -2.6 along, 8.2 along (0.8, 0.6)
  placed.hold(v);
  EXPECT_THAT(v, ElementsAre(DoubleNear(0.6 * 0.5 + 0.8 * 8.2, 1e-12), DoubleNear(-0.8 * 0.5 + 0.6 * 8.2, 1e-12)));
  EXPECT_THAT(placed.free_part({5.0, 7.0}), ElementsAre(DoubleNear(0.8 * 8.2, 1e-12), DoubleNear(0.6 * 8.2, 1e-12)));
}

}  // namespace footing_test
