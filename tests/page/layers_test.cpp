#include "page/layers.hpp"
#include "support/test.hpp"

namespace layers_test {

/// Points at the middles of squares of 1 m: sand below y = 2, clay above, 10 by 4.
struct Layers : testing::Test {
  std::vector<Real> places, materials;
  Case description;

  Layers()
  {
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 4; ++j) {
        places.insert(places.end(), {i + 0.5, j + 0.5});
        materials.push_back(j < 2 ? 0.0 : 1.0);
      }
    description.materials.resize(2);
    description.materials[0].name = "sand", description.materials[1].name = "clay";
    description.bodies.resize(2);
    description.bodies[0].material = "sand", description.bodies[1].material = "clay";
    description.bodies[0].polygon = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 4.0}, {0.0, 4.0}};  // clay lies on its upper half
    description.bodies[1].polygon = {{0.0, 2.0}, {10.0, 2.0}, {10.0, 4.0}, {0.0, 4.0}};
  }
  PointsAtStart points() const { return {places, materials, 1.0}; }
  std::vector<SoilLayer> layers() const { return attach_layers(description, {}, points()); }
  Vec<2> place(const AttachedLines& lines, std::size_t k) const
  {
    return {
        places[2 * lines.points[k]] + lines.offsets[2 * k], places[2 * lines.points[k] + 1] + lines.offsets[2 * k + 1]};
  }
};

TEST_F(Layers, OutlinesAreWhereTheyWereDrawnAndOnPointsOfTheirSoil)
{
  const SoilLayer clay = layers()[1];
  EXPECT_EQ(clay.soil, "clay");
  for (std::size_t k = 0; k < clay.lines.points.size(); ++k) {
    ASSERT_NE(clay.lines.points[k], AttachedLines::gap);
    EXPECT_EQ(materials[clay.lines.points[k]], 1.0);
    const Vec<2> x = place(clay.lines, k);
    EXPECT_TRUE(x[1] == 2.0 || x[1] == 4.0 || x[0] == 0.0 || x[0] == 10.0) << x[0] << ' ' << x[1];
  }
  EXPECT_EQ(clay.lines.points.size(), 24u + 1u);  // a place each metre, the first again
}

TEST_F(Layers, WhatAnotherBodyCoversIsLeftOut)
{
  const SoilLayer sand = layers()[0];
  for (std::size_t k = 0; k < sand.lines.points.size(); ++k)
    if (sand.lines.points[k] != AttachedLines::gap) {
      EXPECT_LE(place(sand.lines, k)[1], 3.0);
    }
}

TEST_F(Layers, ANameStandsInItsSoilNearTheLeft)
{
  for (const SoilLayer& layer : layers()) {
    ASSERT_EQ(layer.middle.points.size(), 1u);
    EXPECT_LT(place(layer.middle, 0)[0], 2.0);
    EXPECT_NEAR(place(layer.middle, 0)[1], layer.soil == "sand" ? 1.0 : 3.0, 1e-6);
  }
}

TEST_F(Layers, PointsWithoutSoilCarryNothing)
{
  std::ranges::fill(places, std::nan(""));
  std::ranges::fill(materials, std::nan(""));
  EXPECT_TRUE(attach_surface(points(), 3.0, 6.0).is_empty());
  EXPECT_TRUE(layers()[0].lines.is_empty());
  EXPECT_TRUE(layers()[0].middle.is_empty());
}

TEST_F(Layers, ALoadLiesOnTheHighestPoints)
{
  const AttachedLines load = attach_surface(points(), 3.0, 6.0);
  ASSERT_EQ(load.points.size(), 3u);
  EXPECT_EQ(place(load, 0), (Vec<2>{3.5, 4.0}));
}

}  // namespace layers_test
