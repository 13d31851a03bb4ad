// The drawing of a section names what it shows; it is looked at by eye when it changes.
#include "io/files/section_svg.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"
#include "support/stages.hpp"

namespace section_svg_test {

std::string drawing_of(const Case& c)
{
  Model model = build_model(c, 1);
  return draw_section(model, build_state(model));
}

TEST(SectionSvg, NamesBodiesSidesPointsAndGravity)
{
  Case c = column("mpm_gp");
  c.title = "clay < sand";
  c.output.history_points = {{"A", {1.0, 1.0}}};
  c.footings = {{.name = "plate", .low = {1.0, 2.0}, .high = {2.0, 2.5}, .velocity = {0.0, -0.01}}};
  const std::string svg = drawing_of(c);
  for (const char* part : {"<svg xmlns=", "clay &lt; sand", "clay: tresca_softening, 1990 kg/m³ = 19.52 kN/m³",
           "bottom: contact that never opens, adhesion 8 kPa", "left: roller, no motion across", "top: free",
           ">A</text>", ">plate</text>", "g = 9.81 m/s²", "192 cells, 1600 material points", "</svg>\n"})
    EXPECT_THAT(svg, HasSubstr(part));
}

TEST(SectionSvg, DrawsLoadsAndTheWaterToCome)
{
  Case c = column("mpm_gp");
  c.loads = {{.name = "traffic", .from = 1.0, .to = 3.0, .pressure = 13e3}};
  c.water.start.phreatic_line = {{0.0, 1.0}};
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 2.5}, {8.0, 1.5}}}};
  c.flood.water_level = 1.8;
  c.flood.given = true;
  const std::string svg = drawing_of(c);
  for (const char* part : {">traffic, 13 kPa</text>", ">high</text>", "phreatic line of another situation",
           ">level of [flood] 1.8 m</text>"})
    EXPECT_THAT(svg, HasSubstr(part));
  EXPECT_THAT(svg, ContainsRegex("text-anchor=\"middle\"[^>]*>traffic,"));  // above its arrows
  c.mesh.size[1] = 2.0;  // no room below the name of the upper side: beside them
  EXPECT_THAT(drawing_of(c), ContainsRegex("text-anchor=\"end\"[^>]*>traffic,"));
}

// An import puts traffic on in a stage: at t = 0 it is 0 kPa.
TEST(SectionSvg, DrawsALoadWithThePressuresOfTheStages)
{
  Case c = column("mpm_gp");
  c.loads = {{.name = "traffic", .from = 1.0, .to = 3.0, .pressure = 0.0}};
  c = staged(c, {{stage("daily", 1.0), {}}, {stage("flood", 1.0), [](Case& now) { now.loads[0].pressure = 13e3; }},
                    {stage("after", 1.0), [](Case& now) { now.loads[0].pressure = 13e3; }}});
  EXPECT_THAT(drawing_of(c), HasSubstr(">traffic, 0 kPa, 13 kPa in `flood`</text>"));
}

TEST(SectionSvg, DrawsTheSlipPlanesOfOtherMethods)
{
  Case c = column("mpm_gp");
  c.slip_planes = {
      {.name = "flood", .method = "Spencer", .factor_of_safety = 1.2345, .line = {{2.0, 1.0}, {3.0, 0.5}}, .su = {}},
      {.name = "by hand", .method = "", .line = {{1.0, 1.0}, {3.0, 1.5}}, .su = {}}};
  const std::string svg = drawing_of(c);
  EXPECT_THAT(svg, AllOf(HasSubstr(">flood, Spencer, 1.234</text>"), HasSubstr(">by hand</text>")));
  const auto dashes = [&] {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = svg.find("stroke-dasharray=\"9 5\"", at)) != std::string::npos; ++at) ++n;
    return n;
  };
  EXPECT_EQ(dashes(), 4u) << "two lines, and their samples in the legend";
}

TEST(SectionSvg, DrawsNoSideInRedThatIsFree)
{
  Case c = column("mpm_gp");
  EXPECT_THAT(drawing_of(c), HasSubstr("constrained side"));
  c.sides.clear();
  EXPECT_THAT(drawing_of(c), Not(HasSubstr("constrained side")));
}

TEST(SectionSvg, IsNoLargerForMoreCellsThanAPageCanShow)
{
  EXPECT_LT(drawing_of(column("mpm_gp", 0.03125)).size(), 100000u);  // cells of 2 pixels: their lines are left out
}

}  // namespace section_svg_test
