#include "run/stability/border_under_slip.hpp"
#include "run/loop/simulation.hpp"
#include "support/aquifer.hpp"

#include <numbers>

namespace border_under_slip_test {

/// The cover slides along a line from x = 10 to 30 m at a level, under a shear stress of 3 kPa everywhere.
std::optional<BorderUnderSlip> border_below(Real level, Real head = 9.8)
{
  Simulation s(cover(head, head));
  for_each_point(s.state.points, [](const PointBlock<2>& block, Index lane) {
    for (int k = 0; k < 4; ++k) block.row(Rows::sigma + k)[lane] = k == 3 ? 3e3 : 0.0;
  });
  return find_border_under(s.model, s.state, {{10.0, level}, {20.0, level}, {30.0, level}});
}

TEST(BorderUnderSlip, IsWhatARowCarriesMoreBesideTheShearStressAlongTheLine)
{
  const auto border = border_below(4.5);
  ASSERT_TRUE(border.has_value());
  EXPECT_EQ(border->soil, "sand");
  EXPECT_NEAR(border->from, 10.0, 1e-9);
  EXPECT_NEAR(border->to, 30.0, 1e-9);
  EXPECT_NEAR(border->carried_more, 20.0 * std::tan(std::numbers::pi / 6.0) * 10e3 * 0.5, 1e-3);
  EXPECT_NEAR(border->strength, 20.0 * 3e3, 1e-6);
}

TEST(BorderUnderSlip, IsNoneOfASlipElsewhereOrOfWaterThatDoesNotPush)
{
  EXPECT_FALSE(border_below(3.5)) << "in the sand";
  EXPECT_FALSE(border_below(6.5)) << "in the clay";
  EXPECT_FALSE(border_below(4.5, 8.0));
}

}  // namespace border_under_slip_test
