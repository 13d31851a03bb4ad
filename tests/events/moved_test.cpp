// Soil that is away from where it began.
#include "events/moved.hpp"

#include "mesh/mesh.hpp"
#include "support/blocks.hpp"

#include <gtest/gtest.h>

namespace terp {
namespace {

TEST(MovedVolume, IsThatOfThePointsFartherThanTheDistance)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 2.0}, {4, 2});
  PointBlocks<2> points(mesh.n_cells(), 0);
  test::add_point(mesh, 0, {.volume = 0.25, .id = 2.0}, points);  // at (0.5, 0.5)
  test::add_point(mesh, 1, {.volume = 0.5, .id = 0.0}, points);   // at (1.5, 0.5)
  test::add_point(mesh, 2, {.volume = 2.0, .id = 1.0}, points);   // at (2.5, 0.5)
  points.update_occupied();
  const std::vector<Real> x_initial{1.5, 0.81, 2.5, 0.5, 0.2, 0.1};  // moved by 0.31, 0 and 0.5 m
  EXPECT_EQ(moved_volume(points, x_initial, 0.1), 0.75);
  EXPECT_EQ(moved_volume(points, x_initial, 0.4), 0.25);
  EXPECT_EQ(moved_volume(points, x_initial, 0.501), 0.0);
}

}  // namespace
}  // namespace terp
