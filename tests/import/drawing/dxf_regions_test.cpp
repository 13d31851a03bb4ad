#include "import/drawing/dxf_regions.hpp"
#include "support/test.hpp"

namespace dxf_regions_test {

TEST(DxfRegions, AreTheClosedPolylines)
{
  const DxfDrawing drawing{
      {{"sand", {{0, 0}, {4, 0}, {4, 1}, {0, 1}}, true, ""}, {"clay", {{0, 1}, {4, 1}, {4, 3}, {0, 3}}, true, ""}}, {}};
  const auto found = regions_of(drawing, 0.01);
  ASSERT_EQ(found.regions.size(), 2u);
  EXPECT_EQ(found.regions[1].name, "clay");
  EXPECT_TRUE(found.notes.empty());
}

TEST(DxfRegions, AreWhatLooseLinesEnclose)
{
  // The ground, both limits, the base, and a boundary whose ends miss the limits by 4 mm; one line ends nowhere.
  const DxfDrawing drawing{{{"ground", {{0, 4}, {3, 6}, {7, 6}, {10, 4}}, false, ""},
                               {"ground", {{0, 4}, {0, 0}, {10, 0}, {10, 4}}, false, ""},
                               {"clay", {{0.004, 2}, {10.004, 2}}, false, ""}, {"axis", {{5, 5}, {5, 9}}, false, ""}},
      {}};
  const auto found = regions_of(drawing, 0.01);
  ASSERT_EQ(found.regions.size(), 2u);
  EXPECT_EQ(found.regions[0].name, "region 1");
  EXPECT_EQ(found.regions[1].name, "region 2");
  EXPECT_THAT(signed_area(found.regions[0].polygon) + signed_area(found.regions[1].polygon), DoubleNear(54.0, 0.05));
  EXPECT_EQ(found.notes.size(), 1u);
  ASSERT_EQ(found.doubts.size(), 1u);
  EXPECT_THAT(found.doubts[0], HasSubstr("left out, 4.00 m on axis; the first ends at 5.000, 5.000 m"));
}

TEST(DxfRegions, HaveTheNameOfThePolylineAroundThem)
{
  const DxfDrawing drawing{
      {{"sand", {{0, 0}, {4, 0}, {4, 1}, {0, 1}}, true, ""}, {"cut", {{2, -1}, {2, 2}}, false, ""}}, {}};
  const auto found = regions_of(drawing, 0.01);
  ASSERT_EQ(found.regions.size(), 2u);
  EXPECT_EQ(found.regions[0].name, "sand");
  EXPECT_EQ(found.regions[1].name, "sand");
}

TEST(DxfRegions, AreFoundAmongThousandsOfLines)
{
  DxfDrawing drawing;
  for (int k = 0; k <= 20; ++k)
    for (int x = 0; x < 300; ++x)
      drawing.lines.push_back(
          {"a", {{0.5 * x, k + 0.2 * std::sin(x + k)}, {0.5 * (x + 1), k + 0.2 * std::sin(x + 1 + k)}}, false, ""});
  for (const Real x : {0.0, 150.0}) drawing.lines.push_back({"a", {{x, -1}, {x, 22}}, false, ""});
  EXPECT_EQ(regions_of(drawing, 0.01).regions.size(), 20u);
}

}  // namespace dxf_regions_test
