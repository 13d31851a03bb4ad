#include "support/simulations.hpp"

namespace repeat_test {

TEST(Repeat, AChangeOfOneBitIsSeen)
{
  Simulation a(column("mpm_gp")), b(column("mpm_gp"));
  set_value(b.state, 700, Rows::v, -0.0);
  EXPECT_EQ(first_difference(make_image(a.state), make_image(b.state)), "points/velocity");
}

}  // namespace repeat_test
