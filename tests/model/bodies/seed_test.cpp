// Bodies that outlines cut anyhow: seed_cut_test.cpp.
#include "model/bodies/seed.hpp"
#include "support/meshes.hpp"

namespace seed_test {

Polygon box(Vec<2> low, Vec<2> high) { return {low, {high[0], low[1]}, high, {low[0], high[1]}}; }

Real total_volume(const std::vector<Seed>& seeds, Index body = -1)
{
  long double sum = 0.0;  // 40000 equal terms would add up the same round-off
  for (const auto& seed : seeds)
    if (body < 0 || seed.body == body) sum += seed.volume;
  return static_cast<Real>(sum);
}

TEST(SeedPoints, FillABoxAlignedWithTheMeshToTheLastDrop)
{
  const std::vector<BodyOutline> bodies{{box({0.0, 0.0}, {8.0, 2.0}), {5, 5}}};
  const auto seeds = seed_points(make_rectangle({0.0, 0.0}, {16.0, 3.0}, {160, 30}), bodies);
  EXPECT_EQ(seeds.size(), 80u * 20u * 25u);
  EXPECT_NEAR(total_volume(seeds), 16.0, 16.0 * 1e-12);
  for (const auto& seed : seeds) {
    ASSERT_LT(seed.x[0], 8.0);
    ASSERT_LT(seed.x[1], 2.0);
    ASSERT_NEAR(seed.volume, 4e-4, 4e-4 * 1e-12);
  }
}

TEST(SeedPoints, LieAtTheMiddlesOfALatticeRowByRow)
{
  const std::vector<BodyOutline> bodies{{box({0.0, 0.0}, {9.0, 9.0}), {3, 2}}};
  const auto seeds = seed_points(make_rectangle({1.0, 2.0}, {0.6, 0.4}, {1, 1}), bodies);
  ASSERT_EQ(seeds.size(), 6u);
  EXPECT_THAT(seeds[0].x, ElementsAre(DoubleNear(1.1, 1e-15), DoubleNear(2.1, 1e-15)));
  EXPECT_THAT(seeds[1].x, ElementsAre(DoubleNear(1.3, 1e-15), DoubleNear(2.1, 1e-15)));
  EXPECT_THAT(seeds[5].x, ElementsAre(DoubleNear(1.5, 1e-15), DoubleNear(2.3, 1e-15)));
  EXPECT_THAT(seeds[5].local, ElementsAre(DoubleNear(2.0 / 3.0, 1e-15), DoubleNear(0.5, 1e-15)));
  EXPECT_NEAR(seeds[3].volume, 0.04, 1e-16);
}

TEST(SeedPoints, ShareOutTheWholeVolumeOfDistortedCells)
{
  const auto mesh = distorted_rectangle(6, 5, 0.2, 0.3, 31);
  const std::vector<BodyOutline> bodies{{box({-1.0, -1.0}, {9.0, 9.0}), {4, 3}}};
  const auto seeds = seed_points(mesh, bodies);
  std::vector<Real> of_cell(mesh.n_cells(), 0.0);
  for (const auto& seed : seeds) of_cell[seed.cell] += seed.volume;
  for (Index e = 0; e < mesh.n_cells(); ++e) EXPECT_NEAR(of_cell[e], mesh.geometry(e).volume, 1e-15);
}

TEST(SeedPoints, FillWholeCellsOfARegionAndLetLaterPolygonsLieOnTop)
{
  const auto mesh = distorted_rectangle(6, 5, 0.2, 0.3, 33);
  const std::vector<BodyOutline> bodies{{{}, {3, 3}, {}, {2, 3, 8, 9}}, {box({0.5, 0.1}, {0.7, 0.3}), {4, 4}}};
  const auto seeds = seed_points(mesh, bodies);
  Real region = 0.0;
  for (const Index cell : bodies[0].cells) region += mesh.geometry(cell).volume;
  EXPECT_NEAR(total_volume(seeds, 1), 0.04, 1e-15);
  const std::vector<BodyOutline> alone{bodies[0]};
  EXPECT_NEAR(total_volume(seed_points(mesh, alone)), region, 1e-15);
  const std::vector<BodyOutline> region_on_top{bodies[1], bodies[0]};
  EXPECT_NEAR(total_volume(seed_points(mesh, region_on_top), 1), region, 1e-15);
  for (const auto& seed : seeds) EXPECT_EQ(seed.body == 1, covers(bodies[1], seed.x));
  for (const auto& seed : seed_points(mesh, alone)) EXPECT_EQ(std::ranges::count(bodies[0].cells, seed.cell), 1);
}

TEST(SeedPoints, FarFromTheOriginFollowTheMeshAllTheSame)
{
  const Vec<2> origin{155000.3, 463000.7};  // a national grid, in metres
  const auto mesh = make_rectangle(origin, {4.0, 2.0}, {40, 20});
  const std::vector<BodyOutline> bodies{
      {box({origin[0] + 0.3, origin[1]}, {origin[0] + 1.7, origin[1] + 1.1}), {5, 5}}};
  const auto seeds = seed_points(mesh, bodies);
  EXPECT_EQ(seeds.size(), 14u * 11u * 25u);
  EXPECT_NEAR(total_volume(seeds), 1.54, 1.54 * 1e-9);  // the corners themselves are known to 6e-11 m
}

}  // namespace seed_test
