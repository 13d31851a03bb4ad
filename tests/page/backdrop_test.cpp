#include "page/backdrop.hpp"
#include "support/test.hpp"

namespace backdrop_test {

TEST(Backdrop, EachLineOfTheMeshIsThereOnce)
{
  const auto edges = mesh_edges(make_rectangle({0.0, 0.0}, {3.0, 2.0}, {3, 2}));
  EXPECT_EQ(edges.size() / 4, 3 * 3 + 4 * 2);
  Real length = 0.0;
  for (std::size_t k = 0; k < edges.size(); k += 4)
    length += std::hypot(edges[k + 2] - edges[k], edges[k + 3] - edges[k + 1]);
  EXPECT_NEAR(length, 17.0, 1e-6);
}

TEST(Backdrop, OutlinesAreClosedAndApart)
{
  Case c;
  c.bodies.resize(2);
  c.bodies[0].polygon = {{0.0, 0.0}, {2.0, 0.0}, {0.0, 1.0}};
  c.bodies[1].polygon = {{5.0, 0.0}, {6.0, 0.0}, {5.0, 1.0}};
  const auto line = first_outline(c, make_rectangle({0.0, 0.0}, {1.0, 1.0}, {1, 1}));
  ASSERT_EQ(line.size(), 2 * (4 + 1 + 4));
  EXPECT_EQ(line[6], line[0]);
  EXPECT_TRUE(std::isnan(line[8]) && std::isnan(line[9]));
  EXPECT_EQ(line[10], 5.0f);
}

TEST(Backdrop, ABodyOfCellsHasTheirOutline)
{
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 1});
  mesh.regions = {{"clay", {0, 1}}};
  Case c;
  c.bodies.resize(1);
  c.bodies[0].region = "clay";
  EXPECT_EQ(first_outline(c, mesh).size() / 2, 6 * 2 + 5);  // six sides, five gaps
}

TEST(Backdrop, TheSurfaceIsTheHighestPointPerColumn)
{
  const auto line = surface_line({0.1, 1.0, 0.4, 2.0, 1.6, 0.5, std::nan(""), std::nan("")}, {0.5, 0.125});
  EXPECT_THAT(line, ElementsAre(0.4f, 2.125f, 1.6f, 0.625f));
}

TEST(Backdrop, ThePhreaticLineIsThatOfTheStage)
{
  Case c;
  c.water.start.phreatic_line = {{0.0, 1.0}};
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 3.0}}}};
  StageCase daily, flood, after;
  daily.name = "daily", flood.name = "flood", after.name = "after";
  flood.water = "high", flood.ramp = 4.0, after.water = "start", after.ramp = 2.0;
  c.stages = {daily, flood, after};
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {3.0, 2.0}, {3, 2});
  const std::vector<StageSummary> ended = {
      {"daily", {.start = 0.0, .end = 2.0}}, {"flood", {.start = 2.0, .end = 10.0}}};
  Real begin = 0.0;
  const auto level = [&](Real time) { return phreatic_line(c, ended, mesh, begin, time).at(1); };
  EXPECT_EQ(level(1.0), 1.0f);
  EXPECT_EQ(level(2.0), 1.0f);
  EXPECT_EQ(level(3.0), 1.5f);  // a quarter of the ramp
  EXPECT_EQ(level(9.0), 3.0f);
  EXPECT_EQ(level(11.0), 2.0f);  // of the stage that goes on
  c.stages.clear();
  c.water.situations[0].time = 8.0;
  EXPECT_EQ(level(2.0), 1.5f);
  EXPECT_EQ(level(9.0), 3.0f);
}

TEST(Backdrop, ThePhreaticLineOfAGridIsWhereItsWaterStands)
{
  Case c;
  c.water.start.phreatic_line = {{0.0, 1.0}};
  c.water.situations = {{.name = "high", .time = 8.0}};
  c.water.situations[0].formula = [](Vec<2> x, Real) { return 9810.0 * std::max(1.5 - x[1], 0.0); };
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {3.0, 2.0}, {3, 2});
  EXPECT_NEAR(phreatic_line(c, {}, mesh, 0.0, 4.0).at(1), 1.25, 1e-6);
  EXPECT_NEAR(phreatic_line(c, {}, mesh, 0.0, 8.0).at(1), 1.5, 1e-6);
}

// A run that goes on from another one does not begin at t = 0.
TEST(Backdrop, TheRampOfTheFirstStageBeginsWithTheRun)
{
  Case c;
  c.water.start.phreatic_line = {{0.0, 1.0}};
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 3.0}}}};
  StageCase flood;
  flood.name = "flood", flood.water = "high", flood.ramp = 4.0;
  c.stages = {flood};
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {3.0, 2.0}, {3, 2});
  EXPECT_EQ(phreatic_line(c, {}, mesh, 10.0, 10.0).at(1), 1.0f);
  EXPECT_EQ(phreatic_line(c, {}, mesh, 10.0, 11.0).at(1), 1.5f);
  EXPECT_EQ(phreatic_line(c, {{"flood", {.start = 10.0, .end = 20.0}}}, mesh, 10.0, 11.0).at(1), 1.5f);
}

TEST(Backdrop, AStepOfThePhreaticLineIsVertical)
{
  Case c;
  c.water.start.phreatic_line = {{0.0, 1.0}, {1.0, 1.0}, {1.0, 0.5}, {3.0, 0.5}};
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {3.0, 2.0}, {3, 2});
  EXPECT_EQ(phreatic_line(c, {}, mesh, 0.0, 0.0), (std::vector<float>{0, 1, 1, 1, 1, 0.5, 3, 0.5}));
}

// Two columns of three points, 2 m wide; the river stands above the first, the line runs through the second.
TEST(Backdrop, ThePhreaticLineGoesWithTheSoil)
{
  const SurfaceColumns columns{2.0, 0.5};
  const std::vector<Real> first{1.0, 0.5, 3.0, 0.5, 3.0, 1.5, 3.0, 2.5};
  const std::vector<float> line{0, 2, 4, 2};
  EXPECT_EQ(water_in_moved_soil(first, first, line, columns), line);
  const std::vector<Real> slid{1.0, 0.5, 5.0, 0.5, 5.0, 1.5, 5.0, 2.5};  // its line with it; none where it was
  EXPECT_EQ(water_in_moved_soil(first, slid, {std::array{0.0f, 2.0f, 6.0f, 2.0f}}, columns),
      (std::vector<float>{0, 2, 5, 2, 6, 2}));
  const std::vector<Real> spread{1.0, 0.5, 3.0, 0.5, 5.0, 0.5, 5.0, 1.5};
  EXPECT_EQ(water_in_moved_soil(first, spread, {std::array{0.0f, 2.0f, 6.0f, 2.0f}}, columns),
      (std::vector<float>{0, 2, 5, 1, 6, 2}));
}

}  // namespace backdrop_test
