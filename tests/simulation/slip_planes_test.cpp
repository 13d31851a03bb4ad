// Slip planes of other methods in words.
#include "simulation/slip_planes.hpp"
#include "support/test.hpp"

namespace {

TEST(SlipPlanes, AreNamedWithWhatIsKnownOfThem)
{
  SlipPlaneCase plane;
  plane.name = "flood";
  EXPECT_EQ(words_of(plane), "flood");
  plane.method = "Bishop", plane.factor_of_safety = 1.0043;
  EXPECT_EQ(words_of(plane), "flood, Bishop, 1.004");
}

}  // namespace
