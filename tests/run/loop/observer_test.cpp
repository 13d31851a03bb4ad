#include "run/loop/observer.hpp"
#include "support/test.hpp"

namespace observer_test {

Frame frame_of(std::int64_t n_points, std::int64_t first, std::int64_t n_all)
{
  Frame frame;
  frame.x.resize(2 * n_points);
  frame.first = first;
  frame.n_all = n_all;
  return frame;
}

TEST(Frame, WithoutATotalIsWhole)
{
  const Frame frame = frame_of(7, 0, 0);
  EXPECT_EQ(frame.n_points(), 7);
  EXPECT_EQ(frame.n_whole(), 7);
  EXPECT_TRUE(frame.ends());
}

TEST(Frame, InPartsEndsWithThePartThatHoldsTheLastPoint)
{
  EXPECT_FALSE(frame_of(4, 0, 10).ends());
  EXPECT_FALSE(frame_of(4, 4, 10).ends());
  EXPECT_TRUE(frame_of(2, 8, 10).ends());
  EXPECT_EQ(frame_of(4, 4, 10).n_whole(), 10);
}

TEST(Frame, WithoutPointsIsWholeToo) { EXPECT_TRUE(frame_of(0, 0, 0).ends()); }

}  // namespace observer_test
