#include "math/closest.hpp"
#include "support/test.hpp"

namespace closest_test {

TEST(Closest, CountsASwapOfNeighboursAsOneEdit)
{
  EXPECT_EQ(edit_distance("su_resdiual", "su_residual"), 1);
  EXPECT_EQ(edit_distance("abc", "abc"), 0);
  EXPECT_EQ(edit_distance("ab", "abcd"), 2);
  EXPECT_EQ(edit_distance("", "cell"), 4);
  EXPECT_EQ(edit_distance("cell", "call"), 1);
}

TEST(Closest, IgnoresCase) { EXPECT_EQ(edit_distance("Gravity", "gravity"), 0); }

TEST(Closest, TakesTheNearestName)
{
  EXPECT_EQ(closest("densty", {"shear_modulus", "density", "eta"}), "density");
  EXPECT_EQ(closest("flp", {"flow", "flip"}), "flip");   // one letter in four
  EXPECT_EQ(closest("wieght", {"weights"}), "weights");  // two in seven
  EXPECT_EQ(closest("sane", {"size"}), "");              // two in four
  EXPECT_EQ(closest("en", {"end"}), "end");              // one in three is the limit
  EXPECT_EQ(closest("siez", {"cell", "size"}), "size");
}

TEST(Closest, SaysNothingWhenNothingIsNear)
{
  EXPECT_EQ(closest("youngs_modulus", {"eta", "density"}), "");
  EXPECT_EQ(closest("foo", {"box"}), "");
}

}  // namespace closest_test
