#include "import/drawing/point_section.hpp"
#include "support/test.hpp"

namespace point_section_test {

struct PointSet {
  std::vector<Vec<2>> places;
  std::vector<Real> volumes;
  std::vector<int> materials;

  /// Points of 0.1 m in a box.
  void fill(Vec<2> low, Vec<2> high, int material)
  {
    for (Real y = low[1] + 0.05; y < high[1]; y += 0.1)
      for (Real x = low[0] + 0.05; x < high[0]; x += 0.1) {
        places.push_back({x, y});
        volumes.push_back(0.01);
        materials.push_back(material);
      }
  }
};

TEST(PointSection, HasTheAreaOfItsPoints)
{
  PointSet set;
  set.fill({0, 0}, {6, 1.5}, 0);
  const auto found = regions_of_points(set.places, set.volumes, set.materials);
  EXPECT_NEAR(found.box, 0.3, 1e-12);
  ASSERT_EQ(found.regions.size(), 1u);
  EXPECT_NEAR(signed_area(found.regions[0].polygon), 9.0, 1e-9);
}

TEST(PointSection, HasAnOutlineForEachMaterial)
{
  PointSet set;
  set.fill({0, 0}, {6, 1.5}, 3);
  set.fill({0, 1.5}, {3, 3.0}, 1);
  const auto found = regions_of_points(set.places, set.volumes, set.materials);
  ASSERT_EQ(found.regions.size(), 2u);
  for (const CleanRegion& region : found.regions)
    EXPECT_NEAR(signed_area(region.polygon), region.drawn == 3 ? 9.0 : 4.5, 1e-6);
}

TEST(PointSection, StraightensTheStepsOfASlope)
{
  PointSet set;
  for (int k = 0; k < 60; ++k) set.fill({0.0, 0.1 * k}, {12.0 - 0.1 * k, 0.1 * (k + 1)}, 0);
  const auto found = regions_of_points(set.places, set.volumes, set.materials);
  ASSERT_EQ(found.regions.size(), 1u);
  EXPECT_LT(found.regions[0].polygon.size(), 12u);
  EXPECT_NEAR(signed_area(found.regions[0].polygon), 54.0, 1.0);  // 12 by 6 less a triangle of 18
}

TEST(PointSection, DoesNotSeeASinglePointInTheAirAsAnOutline)
{
  PointSet set;
  set.fill({0, 0}, {6, 1.5}, 0);
  set.places.push_back({3.0, 5.0});
  set.volumes.push_back(0.001);
  set.materials.push_back(0);
  const auto found = regions_of_points(set.places, set.volumes, set.materials);
  EXPECT_EQ(found.regions.size(), 1u);
  EXPECT_TRUE(regions_of_points({}, {}, {}).regions.empty());
}

}  // namespace point_section_test
