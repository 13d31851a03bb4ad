#include "import/drawing/tidy_lines.hpp"
#include "import/drawing/drawn_sections.hpp"
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
  const TidyLines wide = tidy_lines({{opened(sand, {0.0, 0.12}), clay}}, 0.01);
  EXPECT_FALSE(wide.lines[0].closed);
}

TEST(TidyLines, TakeNoFrameForSoil)
{
  const DxfRegions found = regions({{"1", {{-10, -12}, {50, -12}, {50, 22}, {-10, 22}}, true, ""},
      {"1", {{-9, -11}, {49, -11}, {49, 21}, {-9, 21}}, true, ""}, {"1", {{20, -11}, {20, -8}}, false, ""}});
  expect_section(found);
  EXPECT_THAT(
      found.doubts, ElementsAre("Outlines that hold all others and touch none were taken as a frame, not as soil: 1."));
}

TEST(TidyLines, TakeNoFrameForSoilThatTouchesTheSection)
{
  const DxfLine frame{"kader", {{0, -4}, {60, -4}, {60, 12}, {0, 12}}, true, ""},
      box{"title block", {{40, -4}, {60, -4}, {60, 0}, {40, 0}}, true, ""};
  const DxfRegions found = regions({frame, box, {"legend", {{40, 0}, {60, 0}}, false, ""}});
  expect_section(found);
  EXPECT_THAT(found.doubts, ElementsAre(HasSubstr("frame bound no soil: kader, legend, title block")));
  DxfLine unnamed = frame;
  unnamed.layer = "A-12";
  EXPECT_THAT(refusal<InputError>([&] { regions({unnamed}); }),
      HasSubstr("A frame: --layers 'clay,dike,sand'. Soil: --layers 'A-12,clay,dike,sand'."));
  unnamed.layer = "zand";
  EXPECT_EQ(regions({unnamed}).regions.size(), 4u);
  unnamed.layer = "kader";
  EXPECT_EQ(regions_of({.lines = {sand, clay, dike, unnamed}, .layers_are_chosen = true}, 0.01).regions.size(), 4u);
}

DxfLine moved(DxfLine line, Vec<2> by)
{
  for (Vec<2>& x : line.places) x = {x[0] + by[0], x[1] + by[1]};
  return line;
}

TEST(TidyLines, OfSeveralSectionsAreRefused)
{
  const auto refused = [](std::vector<DxfLine> lines) {
    return refusal<InputError>([&] { regions_of({std::move(lines)}, 0.01); });
  };
  const std::vector<DxfLine> layers{{"ground", {{0, 0.5}, {18, 3.5}, {40, 0.5}}, false, ""},
      {"base of dike", {{0, 0.5}, {40, 0.5}}, false, ""}, {"top of sand", {{0, -1.5}, {40, -1.5}}, false, ""},
      {"base of sand", {{0, -4}, {40, -4}}, false, ""}};
  for (const Vec<2> by : {Vec<2>{50, 0}, {0, 30}, {50, 30}, {3, 30}, {0, -20}}) {
    std::vector<DxfLine> two = layers, outlines{sand, clay, dike};
    for (const DxfLine& line : layers) two.push_back(moved(line, by));
    for (const DxfLine& line : {sand, clay, dike}) outlines.push_back(moved(line, by));
    EXPECT_THAT(refused(two), AllOf(HasSubstr("holds 2 sections"), HasSubstr("--window -0.1,-4.1,40.1,3.6")));
    EXPECT_THAT(refused(outlines), AllOf(HasSubstr("holds 2 sections"), HasSubstr("--window -0.1,-4.1,40.1,3.6")));
    DxfDrawing one{two};
    keep_window(one, {{-0.1, -4.1}, {40.1, 3.6}});
    EXPECT_EQ(regions_of(one, 0.01).regions.size(), 3u);
    EXPECT_THAT(one.notes, ElementsAre("4 lines outside the window were left out."));
  }
  DxfDrawing all{layers};
  EXPECT_THAT(refusal<InputError>([&] {
    keep_window(all, {{90, 0}, {99, 9}});
  }),
      HasSubstr("no line lies in the window"));
}

TEST(TidyLines, AboveAThickLayerMayBeASectionOfTheirOwn)
{
  std::vector<DxfLine> lines;
  for (const auto& [name, y] : std::map<std::string, Real>{{"a", 0.0}, {"b", -2.0}, {"c", -30.0}, {"d", -33.0}})
    lines.push_back({name, {{0, y}, {40, y}}, false, ""});
  EXPECT_THAT(regions_of({lines}, 0.01).doubts, ElementsAre(HasSubstr("from -30.00 to -2.00 m is thicker than")));
  lines.pop_back();
  EXPECT_THAT(regions_of({lines}, 0.01).doubts, ElementsAre());
}

TEST(TidyLines, OfATableBesideTheSectionAreLeftOut)
{
  std::vector<DxfLine> table;
  for (int k = 0; k < 4; ++k) table.push_back({"text", {{60, 1.0 * k}, {80, 1.0 * k}}, false, ""});
  const DxfRegions found = regions(table);
  expect_section(found);
  EXPECT_THAT(found.notes, Contains("Lines beside the section bound no soil: text."));
}

TEST(TidyLines, OfTwoLayersInOnePlaceNameBoth)
{
  DxfLine peat = moved(clay, {0.003, -0.004});
  peat.layer = "peat";
  const DxfRegions found = regions({peat});
  EXPECT_EQ(found.regions.size(), 3u);
  EXPECT_THAT(found.doubts, ElementsAre(HasSubstr("clay and peat at 0.00, -1.50 m: peat counts")));
  EXPECT_THAT(regions({clay}).doubts, ElementsAre());  // a copy on its own layer
}

TEST(TidyLines, ThatMissEachOtherByALittleAreNamed)
{
  const auto doubt = [](std::vector<DxfLine> lines) { return regions_of({std::move(lines)}, 0.01).doubts.at(0); };
  EXPECT_THAT(doubt({opened(sand, {0.0, 0.05}), clay, dike}), HasSubstr("by 0.050 m at 0.000, -3.950 m (sand)."));
  EXPECT_THAT(doubt({sand, clay, dike, {"border", {{0.05, -3}, {39.94, -3}}, false, ""}}),
      HasSubstr("by 0.050 m at 0.050, -3.000 m (border), by 0.060 m at 39.940, -3.000 m (border)."));
  EXPECT_THAT(doubt({sand, moved(clay, {0.0, 0.02}), dike}), HasSubstr("by 0.020 m at 0.000, -1.480 m (clay)"));
  std::vector<DxfLine> many;
  for (int k = 0; k < 200; ++k) many.push_back(opened(moved(sand, {0.0, 2.5 * k}), {0.0, 0.05}));
  EXPECT_THAT(doubt(many), AllOf(HasSubstr("200 ends of lines miss others: by 0.050 m at 0.000, -3.950 m (sand), by"),
                               HasSubstr("(sand), and 197 more.")));
}

TEST(TidyLines, OfAHatchingAreRefused)
{
  std::vector<DxfLine> lines{{"a", {{0, 0}, {0, 30}}, false, ""}, {"a", {{40, 0}, {40, 30}}, false, ""}};
  for (int k = 0; k < 400; ++k) lines.push_back({"a", {{0, 0.03 * k}, {40, 0.03 * k}}, false, ""});
  EXPECT_THAT(
      refusal<InputError>([&] { regions_of({lines}, 0.01); }), HasSubstr("enclose 399 regions that are thinner"));
}

TEST(TidyLines, ThatLieWithinTheSnapDistanceLeaveNoSlit)
{
  for (const Real gap : {-0.009, -0.008, 0.008, 0.009}) {
    DxfLine raised = moved(dike, {0.0, gap}), above = clay;
    for (std::size_t k = 0; k < 2; ++k) above.places[k][1] += gap;
    const DxfRegions found = regions_of({{sand, above, raised}}, 0.01);
    EXPECT_THAT(found.doubts, ElementsAre());
    const CleanSection clean = clean_regions(found.regions, {}, {.snap = found.snap});
    EXPECT_THAT(clean.gaps, ElementsAre());
    EXPECT_THAT(clean.overlaps, ElementsAre());
    const Polygon& middle = clean.regions.at(1).polygon;  // clay has the corners of its neighbours
    const Vec<2> border[] = {sand.places[2], sand.places[3], raised.places[0], raised.places[1]};
    for (const Vec<2>& x : border) EXPECT_THAT(middle, Contains(x)) << gap;
  }
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
