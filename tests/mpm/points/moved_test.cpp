#include "mpm/points/moved.hpp"
#include "mpm/mesh/mesh.hpp"
#include "support/blocks.hpp"

namespace moved_test {

TEST(MovedVolume, IsThatOfThePointsFartherThanTheDistance)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 2.0}, {4, 2});
  PointBlocks<2> points(mesh.n_cells(), 0);
  add_point(mesh, 0, {.volume = 0.25, .id = 2.0}, points);  // at (0.5, 0.5)
  add_point(mesh, 1, {.volume = 0.5, .id = 0.0}, points);   // at (1.5, 0.5)
  add_point(mesh, 2, {.volume = 2.0, .id = 1.0}, points);   // at (2.5, 0.5)
  points.update_occupied();
  const std::vector<Real> x_initial{1.5, 0.81, 2.5, 0.5, 0.2, 0.1};  // moved by 0.31, 0 and 0.5 m
  EXPECT_EQ(find_moved(points, x_initial, 0.1).volume, 0.75);
  EXPECT_EQ(find_moved(points, x_initial, 0.4).volume, 0.25);
  EXPECT_EQ(find_moved(points, x_initial, 0.501).volume, 0.0);
}

/// Three points of two materials; the first has a state variable.
struct Moved {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 2.0}, {4, 2});
  PointBlocks<2> points{mesh.n_cells(), 2};
  std::vector<Real> x_initial{1.0, 0.5, 3.0, 0.5, 2.5, 0.4, 3.7, 0.5};  // moved by +0.5, -0.5, 0.1 and -0.2 m

  Moved()
  {
    add_point(mesh, 1, {.volume = 1.0, .state = {7.0, 0.001}, .id = 0.0}, points);
    add_point(mesh, 2, {.volume = 3.0, .state = {7.0, 0.011}, .id = 1.0}, points);
    add_point(mesh, 2, {.volume = 5.0, .state = {7.0, 0.0}, .id = 2.0}, points);
    add_point(mesh, 3, {.volume = 9.0, .state = {0.0, 0.0}, .id = 3.0}, points, 1);
    points.update_occupied();
  }
};

TEST(IntactShare, IsOfTheMovedVolumeOfMaterialsThatHavePlasticStrain)
{
  const Moved soil;
  const std::vector<int> rows{Rows::state + 1, -1};
  EXPECT_EQ(intact_share(soil.points, soil.x_initial, 0.15, rows), 0.25);  // 1 of 4; not the second material
  EXPECT_EQ(intact_share(soil.points, soil.x_initial, 0.05, rows), 6.0 / 9.0);
  EXPECT_TRUE(std::isnan(intact_share(soil.points, soil.x_initial, 0.6, rows)));  // nothing moved
  EXPECT_TRUE(std::isnan(intact_share(soil.points, soil.x_initial, 0.05, std::vector<int>{-1, -1})));
}

TEST(Reach, IsThatOfSoilThatCameThatWay)
{
  const Moved soil;
  const MovedSoil moved = find_moved(soil.points, soil.x_initial, 0.15);
  EXPECT_EQ(moved.reach_left, 2.5);
  EXPECT_EQ(moved.reach_right, 1.5);
  EXPECT_TRUE(std::isnan(find_moved(soil.points, soil.x_initial, 0.6).reach_left));
  const MovedSoil none;
  EXPECT_EQ(join(moved, none).reach_left, 2.5);
  EXPECT_EQ(join(none, moved).volume, 13.0);
}

}  // namespace moved_test
