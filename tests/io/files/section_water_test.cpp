#include "io/files/section_svg.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"

namespace section_water_test {

std::string drawing_of(const Case& c, const SectionOverlay& overlay = {})
{
  Model model = build_model(c, 1);
  return draw_section(model, build_state(model), overlay);
}

std::size_t count_of(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
  return n;
}

/// Water at 1 m over an aquifer whose head a flood raises; the head of a second layer stays.
Case two_layers()
{
  Case c = column("mpm_gp");
  WaterSituation& first = c.water.start;
  first.phreatic_line = {{0.0, 1.0}};
  first.head_lines = {{"sand", {{0.0, 1.2}}}, {"gravel", {{0.0, 1.5}}}};
  first.reference_lines = {{{{0.0, 0.5}}, "sand", "sand"}, {{{0.0, 0.25}}, "gravel", "gravel"}};
  c.water.situations = {first};
  c.water.situations[0].name = "flood";
  c.water.situations[0].head_lines[0].places = {{0.0, 1.9}, {8.0, 1.4}};
  return c;
}

TEST(SectionWater, NamesTheHeadsOfTheStartAndThoseThatAFloodChanges)
{
  const std::string svg = drawing_of(two_layers());
  EXPECT_EQ(count_of(svg, ">head `sand`</text>"), 1u);
  EXPECT_EQ(count_of(svg, ">head `gravel`</text>"), 1u);
  EXPECT_EQ(count_of(svg, ">head `sand`, flood</text>"), 1u);
  EXPECT_EQ(count_of(svg, ">head `gravel`, flood</text>"), 0u) << "it is that of the start";
  EXPECT_EQ(count_of(svg, "stroke-dasharray=\"10 3 2 3\""), 4u) << "three lines, and the sample of the legend";
  EXPECT_THAT(svg, AllOf(HasSubstr("head of a layer"), HasSubstr(">reference line</text>")));
}

/// Height of the words on the page [px].
double height_of(const std::string& svg, const std::string& words)
{
  const std::size_t end = svg.find(">" + words + "</text>"), y = svg.rfind(" y=\"", end);
  return end == std::string::npos ? NAN : std::stod(svg.substr(y + 4));
}

TEST(SectionWater, NamesOfLinesThatLieCloseDoNotLieOnEachOtherOrUnderALine)
{
  Case c = two_layers();
  c.water.situations[0].phreatic_line = {{0.0, 1.91}, {8.0, 1.0}};  // the head of the sand is 1.9 m there
  const std::string svg = drawing_of(c);
  EXPECT_EQ(height_of(svg, "head `sand`, flood"), height_of(svg, "flood") + 14.0);
  EXPECT_GT(svg.find(">flood</text>"), svg.rfind("stroke-dasharray=\"10 3 2 3\"/>", svg.find("reference line<")));
}

TEST(SectionWater, ShowsWithAResultOnlyWhatHoldsThen)
{
  SectionOverlay overlay;
  overlay.subtitle = "at failure";
  EXPECT_THAT(drawing_of(two_layers(), overlay), AllOf(Not(HasSubstr("head")), HasSubstr(">phreatic line</text>")));
}

TEST(SectionWater, DrawsTheWaterOfAGrid)
{
  Case c = two_layers();
  c.water.start = {};
  c.water.start.formula = [](Vec<2> x, Real) { return 9810.0 * std::max(1.5 - x[1], 0.0); };
  c.water.situations = {{.name = "flood"}};
  c.water.situations[0].formula = [](Vec<2> x, Real) { return 9810.0 * std::max(1.8 - x[1], 0.0); };
  EXPECT_THAT(drawing_of(c), AllOf(HasSubstr(">phreatic line at the start</text>"), HasSubstr(">flood</text>"),
                                 HasSubstr(">phreatic line of another situation</text>")));
}

}  // namespace section_water_test
