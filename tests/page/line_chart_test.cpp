#include "page/line_chart.hpp"
#include "support/test.hpp"

namespace line_chart_test {

TEST(LineChart, DrawsLinesMarksBarsAndALegend)
{
  const std::string svg = draw_chart({.title = "front <at> the end",
      .x_label = "cell [m]",
      .y_label = "m",
      .lines = {{"as given", {{0.1, 12.0}, {0.2, 13.0}}, 0, 0, true}, {"b", {{0.1, 11.0}, {0.2, 11.5}}, 1, 2, false}},
      .bars = {{{0.0, 14.0}, 0.5, 0}},
      .x_from_zero = true});
  EXPECT_THAT(svg, AllOf(StartsWith("<svg "), EndsWith("</svg>\n"), HasSubstr("front &lt;at&gt; the end"),
                       HasSubstr("stroke-dasharray=\"5 4\""), HasSubstr(">as given</text>"), HasSubstr("<circle ")));
}

TEST(LineChart, HasRoomForLongNumbers)
{
  const auto left_of = [](Real y) {
    const std::string svg = draw_chart({.title = "t", .lines = {{"", {{0.0, 0.0}, {1.0, y}}}}});
    return std::stod(svg.substr(svg.find("<path d=\"M") + 10));
  };
  EXPECT_EQ(left_of(1.0), 66.0);
  EXPECT_NEAR(left_of(1.85e-7), 27.0 + 6.6 * 7.0, 1e-9);  // "1.5e-07" and the label beside it
}

TEST(LineChart, LeavesGapsWhereAValueIsNoNumber)
{
  const Real nan = std::nan("");
  const std::string svg =
      draw_chart({.title = "t", .lines = {{"", {{0.0, 1.0}, {1.0, 2.0}, {2.0, nan}, {3.0, 3.0}, {4.0, 4.0}}}}});
  EXPECT_THAT(svg, AllOf(Not(HasSubstr("nan")), ContainsRegex("d=\"M[0-9. ]+L[0-9. ]+M[0-9. ]+L[0-9. ]+\"")));
}

TEST(LineChart, OfNothingIsEmptyAndOfALevelLineHasAnAxis)
{
  EXPECT_EQ(draw_chart({.title = "t", .lines = {{"", {{0.0, std::nan("")}}}}}), "");
  EXPECT_THAT(draw_chart({.title = "t", .lines = {{"", {{0.0, 5.0}, {1.0, 5.0}}}}}), HasSubstr(">5</text>"));
  EXPECT_THAT(draw_chart({.title = "t", .lines = {{"", {{0.0, 0.0}, {1.0, 0.0}}}}}), HasSubstr(">0</text>"));
}

}  // namespace line_chart_test
