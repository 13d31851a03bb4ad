#include "mpm/mesh/locate.hpp"
#include "mpm/points/move.hpp"
#include "support/blocks.hpp"
#include "support/meshes.hpp"

namespace random_places_test {

constexpr Index nx = 14, ny = 9;
constexpr Real h = 0.1;
constexpr int n_meshes = 20, places_per_mesh = 5000;

/// From no distortion to the most, 35 % of h, at which corners may be almost straight.
Mesh<2> random_mesh(int k) { return distorted_rectangle(nx, ny, h, 0.35 * std::min(1.0, k / 10.0), 100 + k); }

Vec<2> random_place(Random& random) { return {random.between(0.0, nx * h), random.between(0.0, ny * h)}; }

/// Smallest distance of a position to the left of the four sides [m].
Real depth_in_cell(const Mesh<2>& mesh, Index cell, Vec<2> x)
{
  const auto corners = mesh.corners(cell);
  Real least = h;
  for (int s = 0; s < 4; ++s) {
    const Vec<2>&a = corners[s], &b = corners[(s + 1) % 4];
    const Real area = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
    least = std::min(least, area / std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  return least;
}

/// Cells that contain the position by their straight sides, without the inverse map.
int count_owners(const Mesh<2>& mesh, Vec<2> x)
{
  int n = 0;
  for (Index e = 0; e < mesh.n_cells(); ++e) n += depth_in_cell(mesh, e, x) >= 0.0;
  return n;
}

void expect_at(const Mesh<2>& mesh, const Location& at, Vec<2> x)
{
  ASSERT_TRUE(at.inside) << x[0] << ", " << x[1];
  ASSERT_GE(depth_in_cell(mesh, at.cell, x), -1e-12 * h);
  const Vec<2> back = place_in_cell(mesh, at.cell, at.local);
  ASSERT_LE(std::hypot(back[0] - x[0], back[1] - x[1]), 1e-12 * h) << "in cell " << at.cell;
}

TEST(RandomPlaces, AreFoundInOneCellAndGivenBack)
{
  for (int k = 0; k < n_meshes; ++k) {
    const Mesh<2> mesh = random_mesh(k);
    Random random(k);
    for (int p = 0; p < places_per_mesh; ++p) {
      const Vec<2> x = random_place(random);
      const Location at = locate(mesh, x), walked = locate(mesh, x, random.below(mesh.n_cells()));
      ASSERT_NO_FATAL_FAILURE(expect_at(mesh, at, x));
      ASSERT_NO_FATAL_FAILURE(expect_at(mesh, walked, x));
      ASSERT_EQ(count_owners(mesh, x), 1);
      ASSERT_EQ(walked.cell, at.cell);
    }
  }
}

TEST(RandomPlaces, AreNeverLostWhenTheyMove)
{
  for (int k = 0; k < n_meshes; ++k) {
    const Mesh<2> mesh = random_mesh(k);
    Random random(1000 + k);
    PointBlocks<2> points(mesh.n_cells(), 0);
    std::vector<Real> values(points.n_rows());
    const OpenSides closed(mesh.cells.size(), 0);
    points.add({0, 0}, values);
    for (int p = 0; p < places_per_mesh; ++p) {  // steps of up to four cells in any direction, and jumps
      points.update_occupied();
      const Index b = points.first_block(points.occupied().front());
      const PointBlock<2>& block = points.block(b);
      Vec<2> x = random_place(random);
      if (p % 10 != 0)
        for (int d = 0; d < 2; ++d)
          x[d] = std::clamp(block.row(Rows::x + d)[0] + random.between(-4.0 * h, 4.0 * h), 0.0, (d == 0 ? nx : ny) * h);
      for (int d = 0; d < 2; ++d) block.row(Rows::x + d)[0] = x[d];
      ASSERT_EQ(move_to_new_cell(mesh, closed, points, {b, 0}, values), Moved::inside);
      points.update_occupied();
      ASSERT_EQ(points.n_points(), 1);
      const PointBlock<2>& now = points.block(points.first_block(points.occupied().front()));
      for (int d = 0; d < 2; ++d) ASSERT_EQ(now.row(Rows::x + d)[0], x[d]);
      ASSERT_NO_FATAL_FAILURE(expect_at(mesh, {now.cell, {now.row(Rows::xi)[0], now.row(Rows::xi + 1)[0]}, true}, x));
    }
  }
}

TEST(RandomPlaces, OnSidesAndCornersHaveAnOwner)
{
  for (int k = 0; k < n_meshes; ++k) {
    const Mesh<2> mesh = random_mesh(k);
    Random random(2000 + k);
    for (Index e = 0; e < mesh.n_cells(); ++e)
      for (int s = 0; s < 4; ++s) {
        const Vec<2>&a = mesh.nodes[mesh.cells[e][s]], &b = mesh.nodes[mesh.cells[e][(s + 1) % 4]];
        for (const Real t : {0.0, random.between(0.0, 1.0)}) {
          const Vec<2> x{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
          ASSERT_NO_FATAL_FAILURE(expect_at(mesh, locate(mesh, x), x));
          ASSERT_NO_FATAL_FAILURE(expect_at(mesh, locate(mesh, x, random.below(mesh.n_cells())), x));
        }
      }
  }
}

TEST(RandomPlaces, OutsideTheMeshAreSaidToBeOutside)
{
  const Mesh<2> mesh = random_mesh(19);
  Random random(7);
  for (int p = 0; p < 2000; ++p) {
    Vec<2> x = random_place(random);
    const int d = random.below(2);
    x[d] = random.below(2) == 0 ? -random.between(1e-9, 3.0) : (d == 0 ? nx : ny) * h + random.between(1e-9, 3.0);
    EXPECT_FALSE(locate(mesh, x).inside);
  }
}

}  // namespace random_places_test
