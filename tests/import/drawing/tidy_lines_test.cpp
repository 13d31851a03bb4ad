#include "import/drawing/tidy_lines.hpp"
#include "import/drawing/dxf_regions.hpp"
#include "math/errors.hpp"
#include "support/test.hpp"

namespace tidy_lines_test {

const DxfLine sand{"sand", {{0, -4}, {40, -4}, {40, -1.5}, {0, -1.5}}, true, ""},
    clay{"clay", {{0, -1.5}, {40, -1.5}, {40, 0.5}, {0, 0.5}}, true, ""},
    dike{"dike", {{8, 0.5}, {31, 0.5}, {22, 3.5}, {18, 3.5}}, true, ""};

DxfLine opened(DxfLine line, Vec<2> by)
{
  line.places.push_back({line.places[0][0] + by[0], line.places[0][1] + by[1]});
  line.closed = false;
  return line;
}

DxfRegions regions(std::vector<DxfLine> more)
{
  std::vector<DxfLine> lines{sand, clay, dike};
  lines.insert(lines.end(), more.begin(), more.end());
  return regions_of({lines}, 0.01);
}

void expect_section(const DxfRegions& found)
{
  ASSERT_EQ(found.regions.size(), 3u);
  std::map<std::string, Real> area;
  for (const DrawnRegion& region : found.regions) area[region.name] = std::abs(signed_area(region.polygon));
  EXPECT_NEAR(area["sand"], 100.0, 0.1);
  EXPECT_NEAR(area["clay"], 80.0, 0.1);
  EXPECT_NEAR(area["dike"], 40.5, 0.1);
}

TEST(TidyLines, CloseOutlinesThatAreNearlyClosed)
{
  const DxfRegions found =
      regions_of({{opened(sand, {0.0, 0.002}), opened(clay, {0.009, 0.0}), opened(dike, {0, 0})}}, 0.01);
  expect_section(found);
  EXPECT_THAT(found.notes, ElementsAre("2 outlines were closed, by at most 9 mm."));
  const TidyLines wide = tidy_lines({opened(sand, {0.0, 0.12}), clay}, 0.01);
  EXPECT_FALSE(wide.lines[0].closed);
}

TEST(TidyLines, TakeNoFrameForSoil)
{
  const DxfRegions found = regions({{"frame", {{-10, -12}, {50, -12}, {50, 22}, {-10, 22}}, true, ""},
      {"frame", {{-9, -11}, {49, -11}, {49, 21}, {-9, 21}}, true, ""}, {"frame", {{20, -11}, {20, -8}}, false, ""}});
  expect_section(found);
  EXPECT_THAT(found.doubts,
      ElementsAre("Outlines that hold all others and touch none were taken as a frame, not as soil: frame."));
}

TEST(TidyLines, LeaveOutWallsMarksAndWater)
{
  const DxfRegions found = regions({{"sheet pile", {{31, 0.5}, {31, -3}}, false, ""},
      {"notes", {{19.5, 4}, {20.5, 4}}, false, ""}, {"Freatische lijn", {{0, 0}, {40, -0.5}}, false, ""}});
  expect_section(found);
  EXPECT_THAT(found.notes, ElementsAre("Open lines of water bound no soil: Freatische lijn.",
                               "Lines that touch no outline bound no soil: notes.",
                               "Lines that end within an outline bound no soil: sheet pile."));
}

TEST(TidyLines, KeepGroundWhoseNameHasWaterInIt)
{
  const DxfRegions found = regions_of(
      {{{"waterkering", {{0, 0}, {5, 3}, {10, 0}}, false, ""}, {"watergang", {{0, 0}, {10, 0}}, false, ""}}}, 0.01);
  ASSERT_EQ(found.regions.size(), 1u);
  EXPECT_NEAR(signed_area(found.regions[0].polygon), 15.0, 1e-9);
}

TEST(TidyLines, CloseBoundariesWithoutEndsByVerticals)
{
  const std::vector<DxfLine> boundaries{
      {"ground", {{0, 0.5}, {8, 0.5}, {18, 3.5}, {22, 3.5}, {31, 0.5}, {40, 0.5}}, false, ""},
      {"base of dike", {{8, 0.5}, {31, 0.5}}, false, ""}, {"top of sand", {{0, -1.5}, {40, -1.5}}, false, ""},
      {"base of sand", {{0, -4}, {40, -4}}, false, ""}};
  const DxfRegions found = regions_of({boundaries}, 0.01);
  ASSERT_EQ(found.regions.size(), 3u);
  Real sum = 0.0;
  for (const DrawnRegion& region : found.regions) sum += std::abs(signed_area(region.polygon));
  EXPECT_NEAR(sum, 220.5, 1e-6);
  EXPECT_THAT(found.notes, Contains("Boundaries without ends were closed by verticals at x = 0.00, 40.00 m; the lowest "
                                    "line, on layer base of sand, is the base."));
}

TEST(TidyLines, OfAnExportedSectionAreItsOutlines)
{
  expect_section(regions({{"ground_start", {{0, 0.5}, {20, 5}, {40, 0.5}}, false, ""},
      {"ground_end", {{0, 0.6}, {20, 3}, {40, 0.4}}, false, ""}}));
}

TEST(TidyLines, ThatCrossTooOftenAreRefused)
{
  std::vector<DxfLine> lines;
  for (int k = 0; k < 400; ++k) {  // 160 000 crossings
    lines.push_back({"a", {{1.0 * k, -1.0}, {1.0 * k, 400.0}}, false, ""});
    lines.push_back({"a", {{-1.0, 1.0 * k}, {400.0, 1.0 * k}}, false, ""});
  }
  EXPECT_THAT(refusal<InputError>([&] { regions_of({lines}, 0.01); }), HasSubstr("cross too often"));
  lines.resize(1);
  for (int k = 0; k < 60'000; ++k) lines.push_back({"a", {{0.1 * k, 0.0}, {0.1 * k, 1.0}}, false, ""});
  EXPECT_THAT(refusal<InputError>([&] { regions_of({lines}, 0.01); }), HasSubstr("are too many"));
}

}  // namespace tidy_lines_test
