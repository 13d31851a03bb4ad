#include "support/simulations.hpp"

namespace repeat_test {

TEST(Repeat, OneTwoAndFourThreadsGiveTheSameBits)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"}) {
    Case c = column(scheme, 0.25);      // 256 cells: 16 chunks
    c.bodies[0].velocity = {2.0, 0.0};  // points change cell from the first steps on, and soften
    expect_same_bits(c, {2, 4}, {}, 300);
  }
}

TEST(Repeat, AChangeOfOneBitIsSeen)
{
  Simulation a(column("mpm_gp")), b(column("mpm_gp"));
  set_value(b.state, 700, Rows::v, -0.0);
  EXPECT_EQ(first_difference(make_image(a.state), make_image(b.state)), "points/velocity");
}

}  // namespace repeat_test
