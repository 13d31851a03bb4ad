#include "model/bodies/points_of_files.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"
#include "support/paths.hpp"
#include "support/problems.hpp"
#include <fmt/format.h>

namespace points_of_files_test {

/// What is wrong with files of points beside a drawn body of 1 m x 1 m; its cells have 0.0625 m^2.
Problem problem_of_files(const std::vector<std::string>& files, const Polygon& hole = {})
{
  const ScratchFolder folder;
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.5});
  c.folder = folder.path();
  if (!hole.empty()) c.bodies[0].holes = {hole};
  for (const std::string& lines : files) {
    c.bodies.emplace_back().points_file = fmt::format("more{}.csv", c.bodies.size());
    std::ofstream(folder.path() + '/' + c.bodies.back().points_file) << "x,y,volume,material\n" << lines;
  }
  std::vector<Problem> problems = problems_of([&] { make_points(build_model(c, 1)); });
  if (problems.empty()) return {};
  std::string& detail = problems[0].detail;
  for (std::size_t at; (at = detail.find(folder.path())) != std::string::npos;)
    detail.erase(at, folder.path().size() + 1);
  return problems[0];
}

Problem problem_of(const std::string& lines) { return problem_of_files({lines}); }

TEST(PointsOfFiles, ThatHaveNoRoomAreToldWithTheLineOfTheLargest)
{
  const Problem p = problem_of("3.3,1.2,0.01,clay\n3.1,1.1,0.3,clay\n");
  EXPECT_THAT(
      p, told("body[1].points", "the points hold more volume than there is room",
             "more1.csv:3: the point of 0.3 m^2 at (3.1, 1.1) m lies in cell 76, where cells have 0.0625 m^2. Allowed: "
             "0.25 "
             "m^2.\n"
             "Volumes are in m^2 (per metre of thickness); no point may be there twice, nor in a body that is drawn."));
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
  EXPECT_THAT(problem_of(square({2.5, 1.0}, 0.75, 12) + square({2.51, 1.01}, 0.75, 12)),
      told(_, "the points hold more volume than there is room",
          AllOf(HasSubstr(": the point of 0.003906 m^2 at ("),
              HasSubstr(" or beside it. All points there hold 1.125 m^2,\nthese 9 cells have 0.5625 m^2. Allowed"))));
}

TEST(PointsOfFiles, OnePointWithinABodyThatIsDrawnIsEnough)
{
  const Problem p = problem_of("3.1,1.1,0.01,clay\n1.1,0.6,0.01,clay\n");
  EXPECT_THAT(
      p, told("body[1].points", "a point lies in a body that is drawn",
             "more1.csv:3: the point of 0.01 m^2 at (1.1, 0.6) m lies within body[0].\n"
             "No soil may be there twice: leave the point out, or draw that body without its place (`holes`)."));
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
  const Polygon hole = {{1.25, 0.75}, {1.75, 0.75}, {1.75, 1.25}, {1.25, 1.25}};
  EXPECT_EQ(problem_of_files({square({1.25, 0.75}, 0.5, 4)}, hole).what, "");
}

TEST(PointsOfFiles, TwoAtOnePlaceAreToldWithBothLines)
{
  const Problem p = problem_of("3.1,1.1,0.01,clay\n3.3,1.2,0.01,clay\n3.1000000001,1.1,0.02,clay\n");
  EXPECT_THAT(p, told("body[1].points", "two points lie at one place",
                     "more1.csv:2 and more1.csv:4: (3.1, 1.1) m.\nEach point is soil of its own, and no soil may be "
                     "there twice: leave "
                     "one of them out."));
  EXPECT_THAT(problem_of(square({3.0, 1.0}, 0.25, 3) + square({3.0, 1.0}, 0.25, 3)).detail,
      AllOf(StartsWith("more1.csv:2 and more1.csv:11: ("), HasSubstr(") m, and 8 more such places.\n")));
  EXPECT_EQ(problem_of("3.1,1.1,0.01,clay\n3.101,1.1,0.01,clay\n").what, "");  // a hundredth of their size apart
}

TEST(PointsOfFiles, TwoOfTwoFilesAtOnePlaceAreToldWithBothFiles)
{
  const std::string lines = square({3.0, 1.0}, 0.25, 2);
  EXPECT_THAT(problem_of_files({lines, lines}).detail, AllOf(HasSubstr("more1.csv:2 and more2.csv:2: ")));
}

}  // namespace points_of_files_test
