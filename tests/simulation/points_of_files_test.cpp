// Points of files that lie over each other or over drawn bodies are refused with their lines.
#include "simulation/points_of_files.hpp"

#include "base/errors.hpp"
#include "simulation/setup.hpp"
#include "support/cases.hpp"
#include "support/paths.hpp"

#include <fstream>
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace terp {
namespace {

/// What is wrong with a file of points beside a drawn body of 1 m x 1 m; its cells have 0.0625 m^2.
Problem problem_of(const std::string& lines)
{
  const test::ScratchFolder folder;
  std::ofstream(folder.path() + "/more.csv") << "x,y,volume,material\n" << lines;
  Case c = test::free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.5});
  c.folder = folder.path();
  c.bodies.emplace_back().points_file = "more.csv";
  try {
    make_points(build_model(c, 1));
  } catch (const InputError& error) {
    Problem problem = error.problems().at(0);
    for (std::size_t at; (at = problem.detail.find(folder.path())) != std::string::npos;)
      problem.detail.erase(at, folder.path().size() + 1);
    return problem;
  }
  return {};
}

TEST(PointsOfFiles, ThatHaveNoRoomAreToldWithTheLineOfTheLargest)
{
  const Problem p = problem_of("3.3,1.2,0.01,clay\n3.1,1.1,0.3,clay\n");
  EXPECT_EQ(p.key, "body[1].points");
  EXPECT_EQ(p.what, "the points hold more volume than there is room");
  EXPECT_EQ(p.detail,
      "more.csv:3: the point of 0.3 m^2 at (3.1, 1.1) m lies in cell 76, where cells have 0.0625 m^2. Allowed: 0.25 "
      "m^2.\n"
      "Volumes are in m^2 (per metre of thickness); no point may be there twice, nor in a body that is drawn.");
}

/// n x n points of equal volume that fill a square.
std::string square(Vec<2> low, Real side, int n)
{
  std::string lines;
  const Real size = side / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      lines += fmt::format("{},{},{},clay\n", low[0] + (i + 0.5) * size, low[1] + (j + 0.5) * size, size * size);
  return lines;
}

TEST(PointsOfFiles, ThatCrowdTogetherAreTold)
{
  const Problem p = problem_of(square({2.5, 1.0}, 0.75, 12) + square({2.51, 1.01}, 0.75, 12));
  EXPECT_EQ(p.what, "the points hold more volume than there is room");
  EXPECT_THAT(
      p.detail, testing::AllOf(testing::HasSubstr(": the point of 0.003906 m^2 at ("),
                    testing::HasSubstr(
                        " or beside it. All points there hold 1.125 m^2,\nthese 9 cells have 0.5625 m^2. Allowed")));
}

TEST(PointsOfFiles, OnePointWithinABodyThatIsDrawnIsEnough)
{
  const Problem p = problem_of("3.1,1.1,0.01,clay\n1.1,0.6,0.01,clay\n");
  EXPECT_EQ(p.key, "body[1].points");
  EXPECT_EQ(p.what, "a point lies in a body that is drawn");
  EXPECT_EQ(p.detail,
      "more.csv:3: the point of 0.01 m^2 at (1.1, 0.6) m lies within body[0].\n"
      "No soil may be there twice: leave the point out, or draw that body without its place (`holes`).");
  EXPECT_EQ(problem_of(square({1.25, 0.75}, 0.5, 4)).what,
      "a point lies in a body that is drawn");  // a body of two cells, too
}

TEST(PointsOfFiles, MayTouchADrawnBodyAndReachALittleOverItsSide)
{
  EXPECT_EQ(problem_of(square({2.0, 0.5}, 0.5, 4)).what, "");
  EXPECT_EQ(problem_of("1.96,1.0,0.01,clay\n").what, "");  // 0.1 m wide, 0.09 m of it inside
  EXPECT_EQ(problem_of("1.94,1.0,0.01,clay\n").what, "a point lies in a body that is drawn");
}

TEST(PointsOfFiles, MayLieInAHoleOfADrawnBody)
{
  const test::ScratchFolder folder;
  std::ofstream(folder.path() + "/more.csv") << "x,y,volume,material\n" << square({1.25, 0.75}, 0.5, 4);
  Case c = test::free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.5});
  c.folder = folder.path();
  c.bodies[0].holes = {{{1.25, 0.75}, {1.75, 0.75}, {1.75, 1.25}, {1.25, 1.25}}};
  c.bodies.emplace_back().points_file = "more.csv";
  EXPECT_NO_THROW(make_points(build_model(c, 1)));
}

TEST(PointsOfFiles, TwoAtOnePlaceAreToldWithBothLines)
{
  const Problem p = problem_of("3.1,1.1,0.01,clay\n3.3,1.2,0.01,clay\n3.1000000001,1.1,0.02,clay\n");
  EXPECT_EQ(p.key, "body[1].points");
  EXPECT_EQ(p.what, "two points lie at one place");
  EXPECT_EQ(p.detail,
      "more.csv:2 and more.csv:4: (3.1, 1.1) m.\nEach point is soil of its own, and no soil may be there twice: leave "
      "one of them out.");
  EXPECT_THAT(problem_of(square({3.0, 1.0}, 0.25, 3) + square({3.0, 1.0}, 0.25, 3)).detail,
      testing::AllOf(
          testing::StartsWith("more.csv:2 and more.csv:11: ("), testing::HasSubstr(") m, and 8 more such places.\n")));
  EXPECT_EQ(problem_of("3.1,1.1,0.01,clay\n3.101,1.1,0.01,clay\n").what, "");  // a hundredth of their size apart
}

TEST(PointsOfFiles, TwoOfTwoFilesAtOnePlaceAreToldWithBothFiles)
{
  const test::ScratchFolder folder;
  for (const std::string name : {"/one.csv", "/two.csv"})
    std::ofstream(folder.path() + name) << "x,y,volume,material\n" << square({3.0, 1.0}, 0.25, 2);
  Case c = test::free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.5});
  c.folder = folder.path();
  c.bodies.emplace_back().points_file = "one.csv";
  c.bodies.emplace_back().points_file = "two.csv";
  try {
    make_points(build_model(c, 1));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.problems().at(0).detail,
        testing::AllOf(testing::HasSubstr("/one.csv:2 and "), testing::HasSubstr("/two.csv:2: ")));
  }
}

}  // namespace
}  // namespace terp
