#include "io/files/svg.hpp"
#include "support/test.hpp"

namespace svg_test {

TEST(Svg, EscapesWhatMarkupWouldRead)
{
  EXPECT_EQ(escaped_for_markup("a<b>&\"c\"\x1b\nd"), "a&lt;b&gt;&amp;&quot;c&quot;\nd");
}

TEST(Svg, StepsAreOneTwoOrFive)
{
  EXPECT_NEAR(nice_step(10.0, 6.0), 2.0, 1e-12);
  EXPECT_NEAR(nice_step(0.3, 6.0), 0.05, 1e-12);
  EXPECT_NEAR(nice_step(95.0, 10.0), 10.0, 1e-12);
}

}  // namespace svg_test
