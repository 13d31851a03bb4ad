#include "import/drawing/clean_regions.hpp"
#include "math/errors.hpp"
#include "support/random.hpp"

namespace clean_regions_test {

Polygon box(Real x, Real y, Real width, Real height)
{
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Real area(const CleanRegion& region)
{
  Real sum = signed_area(region.polygon);
  for (const Polygon& hole : region.holes) sum += signed_area(hole);
  return sum;
}

bool holds(const CleanRegion& region, Vec<2> x)
{
  return contains(region.polygon, x) &&
         std::ranges::none_of(region.holes, [&](const Polygon& hole) { return contains(hole, x); });
}

std::vector<int> regions_at(const CleanSection& section, Vec<2> x)
{
  std::vector<int> found;
  for (const CleanRegion& region : section.regions)
    if (holds(region, x)) found.push_back(region.drawn);
  return found;
}

std::vector<Real> areas(const CleanSection& section)
{
  std::vector<Real> all;
  for (const CleanRegion& region : section.regions) all.push_back(area(region));
  return all;
}

TEST(CleanRegions, LeaveAsItIsWhatIsClean)
{
  const auto section = clean_regions({{"sand", box(0, 0, 10, 2)}, {"clay", box(0, 2, 10, 3)}}, {}, {});
  EXPECT_THAT(areas(section), ElementsAre(20.0, 30.0));
  EXPECT_EQ(section.corners, 8);
  EXPECT_EQ(section.simplified.largest + section.snaps.largest + section.simplified.area_move, 0.0);
}

TEST(CleanRegions, CarveALayerOutOfTheOneItLiesIn)
{
  const auto section =
      clean_regions({{"lens", box(2, 1, 3, 1)}, {"sand", box(0, 0, 10, 4)}, {"core", box(3, 1.2, 1, 0.5)}}, {}, {});
  ASSERT_EQ(section.regions.size(), 3u);
  EXPECT_THAT(section.changes[0].area, DoubleNear(2.5, 1e-12));
  EXPECT_THAT(section.changes[1].area, DoubleNear(37.0, 1e-12));
  EXPECT_THAT(section.changes[2].area, DoubleNear(0.5, 1e-12));
  EXPECT_EQ(section.regions[0].drawn, 1);  // what lies inside comes later
  EXPECT_EQ(section.regions[2].drawn, 2);
  EXPECT_TRUE(section.overlaps.empty());
}

TEST(CleanRegions, CutExcavations)
{
  const std::vector<DrawnRegion> drawn{{"sand", box(0, 0, 10, 2)}, {"clay", box(0, 2, 10, 1)}};
  const auto section = clean_regions(drawn, {{"ditch", {{3, 3}, {4, 1.5}, {5, 1.5}, {6, 3}}}}, {});
  EXPECT_THAT(section.dug_area, DoubleNear(3.0, 1e-12));  // a trapezoid 3 and 1 m wide, 1.5 m deep
  EXPECT_EQ(section.regions.size(), 3u);                  // the clay is in two pieces
  EXPECT_EQ(section.changes[1].pieces, 2);
  EXPECT_TRUE(regions_at(section, {4.5, 1.6}).empty());
  EXPECT_EQ(regions_at(section, {4.5, 1.4}), std::vector<int>{0});
}

TEST(CleanRegions, CloseTJunctionsAndKeepAreas)
{
  // The clay has a corner 0.4 mm above the sand's edge, and the sand none there.
  const Polygon clay{{0, 2}, {4, 2.0004}, {10, 2}, {10, 3}, {0, 3}};
  const auto section = clean_regions({{"sand", box(0, 0, 10, 2)}, {"clay", clay}}, {}, {});
  EXPECT_EQ(section.snaps.joined, 1);
  EXPECT_TRUE(section.gaps.empty());
  EXPECT_THAT(section.changes[0].area, DoubleNear(20.0, 1e-11));
  EXPECT_THAT(section.changes[1].area, DoubleNear(10.0 - 0.002, 1e-11));
}

TEST(CleanRegions, FillAThinGapAndLeaveAWideOne)
{
  const Polygon clay{{0, 2}, {4, 2.03}, {6, 2}, {8, 2.8}, {10, 2}, {10, 4}, {0, 4}};
  const auto section = clean_regions({{"sand", box(0, 0, 10, 2)}, {"clay", clay}}, {}, {});
  ASSERT_EQ(section.gaps.size(), 2u);
  const auto thin = std::ranges::find_if(section.gaps, [](const DrawingFault& gap) { return gap.area < 0.5; });
  EXPECT_THAT(thin->area, DoubleNear(0.09, 1e-12));
  EXPECT_EQ(thin->drawn.size(), 1u);
  EXPECT_TRUE(regions_at(section, {8.0, 2.3}).empty());
}

TEST(CleanRegions, GiveAnOverlapToTheSmallerOutline)
{
  const auto section = clean_regions({{"small", box(0, 1, 4, 2)}, {"large", box(0, 0, 8, 2)}}, {}, {});
  ASSERT_EQ(section.overlaps.size(), 1u);
  EXPECT_THAT(section.overlaps[0].area, DoubleNear(4.0, 1e-12));
  EXPECT_EQ(regions_at(section, {1.0, 1.5}), std::vector<int>{0});
}

TEST(CleanRegions, RefuseWhatIsNoOutline)
{
  const std::string text = refusal<InputError>([] {
    clean_regions({{"clay", {{0, 0}, {4, 4}, {4, 0}, {0, 4}}}}, {}, {});
  });
  EXPECT_THAT(text, HasSubstr("clay: this outline is no layer\n  the polygon crosses itself: its side from"));
  EXPECT_THAT(refusal<InputError>([] { clean_regions({}, {}, {}); }), HasSubstr("the drawing has no layer"));
  EXPECT_THAT(refusal<InputError>([] {
    clean_regions({{"a", box(0, 0, 1, 1)}}, {{"pit", {{0, 0}}}}, {});
  }),
      HasSubstr("pit: this excavation is no line\n  It has 1 places; it needs at least 2."));
}

struct Drawing {
  std::vector<DrawnRegion> regions;
  std::vector<DrawnExcavation> excavations;
  std::vector<Real> areas;  ///< what each region should have; less than zero: not known by hand
};

using Line = std::vector<Vec<2>>;

/// A boundary from the left to the right limit, with edges down to 1 mm.
Line boundary(Random& random, Real y, Real wave, Index n)
{
  Line line;
  const Real phase = random.between(0, 6), length = random.between(20, 90);
  std::vector<Real> at{0.0, 100.0};
  for (Index k = 2; k < n; ++k)
    at.push_back(k % 9 == 0 ? std::min(at[random.below(k - 1)] + 0.001, 99.99) : random.between(0.1, 99.9));
  std::ranges::sort(at);
  at.erase(std::unique(at.begin(), at.end()), at.end());
  for (const Real x : at) {
    const Real height = y + wave * std::sin(phase + x / length * 6.28) + random.between(-0.02, 0.02);
    line.push_back({std::round(x * 1e3) / 1e3, std::round(height * 1e3) / 1e3});
  }
  line.erase(std::unique(line.begin(), line.end(), [](Vec<2> a, Vec<2> b) { return a[0] == b[0]; }), line.end());
  return line;
}

/// The line as the layer on one side has it: further corners on its edges, or 0.4 mm beside them.
Line with_t_junctions(Random& random, const Line& line)
{
  Line more;
  for (std::size_t k = 0; k < line.size(); ++k) {
    more.push_back(line[k]);
    if (k + 1 == line.size() || line[k + 1][0] - line[k][0] < 0.5 || random.below(8) != 0) continue;
    const Real t = random.between(0.2, 0.8);
    more.push_back({line[k][0] + t * (line[k + 1][0] - line[k][0]),
        line[k][1] + t * (line[k + 1][1] - line[k][1]) + random.between(-4e-4, 4e-4)});
  }
  return more;
}

Real height_at(const Line& line, Real x)
{
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    if (line[k + 1][0] >= x)
      return line[k][1] + (line[k + 1][1] - line[k][1]) * (x - line[k][0]) / (line[k + 1][0] - line[k][0]);
  return line.back()[1];
}

Drawing unpleasant_section(std::uint64_t seed)
{
  Random random(seed);
  Drawing drawing;
  const Index n_layers = 2 + random.below(6);
  std::vector<Line> lines{{{0, 0}, {100, 0}}};
  for (Index k = 1; k < n_layers; ++k)
    lines.push_back(boundary(random, 3.0 * static_cast<Real>(k), 0.8, 4 + random.below(40)));
  lines.push_back(boundary(random, 3.0 * static_cast<Real>(n_layers), 0.8, random.below(3) == 0 ? 700 : 60));
  for (Index k = 0; k < n_layers; ++k) {
    Line outline = random.below(2) == 0 ? with_t_junctions(random, lines[k]) : lines[k];
    const Line above = random.below(2) == 0 ? with_t_junctions(random, lines[k + 1]) : lines[k + 1];
    outline.insert(outline.end(), above.rbegin(), above.rend());
    if (random.below(2) == 0) std::ranges::reverse(outline);
    drawing.areas.push_back(std::abs(signed_area(outline)));
    drawing.regions.push_back({"layer " + std::to_string(k), outline});
  }
  if (random.below(2) == 0) {  // a lens, in it another one
    const Real x = random.between(10, 60), y = height_at(lines[0], x) + 0.9;
    drawing.regions.push_back({"lens", {{x, y}, {x + 8, y + 0.1}, {x + 8.001, y + 0.5}, {x + 1, y + 0.9}}});
    drawing.regions.push_back({"core", {{x + 3, y + 0.3}, {x + 5, y + 0.3}, {x + 4, y + 0.5}}});
    const Real lens = std::abs(signed_area(drawing.regions[n_layers].polygon));
    const Real core = std::abs(signed_area(drawing.regions[n_layers + 1].polygon));
    drawing.areas[0] -= lens;
    drawing.areas.push_back(lens - core);
    drawing.areas.push_back(core);
  }
  if (random.below(2) == 0) {  // a ditch from the ground to the ground, through the layer's corners
    const Line& ground = lines.back();
    const Real x = random.between(20, 70), width = random.between(2, 8), deep = random.between(0.5, 4);
    drawing.excavations.push_back(
        {"ditch", {{x, height_at(ground, x)}, {x + 0.4 * width, height_at(ground, x) - deep},
                      {x + 0.6 * width, height_at(ground, x) - deep}, {x + width, height_at(ground, x + width)}}});
    drawing.areas[n_layers - 1] = drawing.areas[n_layers - 2] = -1.0;
    if (n_layers > 2) drawing.areas[n_layers - 3] = -1.0;
  }
  return drawing;
}

Real distance_to_outline(const Polygon& polygon, Vec<2> x)
{
  Real nearest = 1e30;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2> a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    const Real l2 = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
    const Real t = std::clamp(((x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1])) / l2, 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(a[0] + t * (b[0] - a[0]) - x[0], a[1] + t * (b[1] - a[1]) - x[1]));
  }
  return nearest;
}

/// The region that a place should be in, -1: none; nothing: too near to a boundary to say.
std::optional<int> drawn_at(const Drawing& drawing, Vec<2> x, Real near)
{
  int best = -1;
  for (std::size_t k = 0; k < drawing.regions.size(); ++k) {
    const Polygon& polygon = drawing.regions[k].polygon;
    if (distance_to_outline(polygon, x) < near) return std::nullopt;
    if (contains(polygon, x) &&
        (best < 0 || std::abs(signed_area(polygon)) < std::abs(signed_area(drawing.regions[best].polygon))))
      best = static_cast<int>(k);
  }
  for (const DrawnExcavation& pit : drawing.excavations) {
    Polygon closed = pit.places;
    closed.push_back({closed.back()[0], 1e3});
    closed.push_back({closed.front()[0], 1e3});
    if (distance_to_outline(closed, x) < near) return std::nullopt;
    if (contains(closed, x)) best = -1;
  }
  return best;
}

class UnpleasantSection : public testing::TestWithParam<int> {};

TEST_P(UnpleasantSection, KeepsItsAreasAndHasOneRegionAtEachPlace)
{
  const Drawing drawing = unpleasant_section(GetParam());
  const CleaningOptions options;
  const auto section = clean_regions(drawing.regions, drawing.excavations, options);
  Real faults = 0.0;  // slivers between corners that lie beside edges
  for (const auto* all : {&section.gaps, &section.overlaps})
    for (const DrawingFault& fault : *all) faults += fault.area;
  EXPECT_LT(faults, 0.02);
  for (std::size_t k = 0; k < drawing.areas.size(); ++k) {
    EXPECT_NEAR(section.changes[k].area, section.changes[k].drawn_area, 1e-10 * section.changes[k].drawn_area) << k;
    if (drawing.areas[k] > 0.0) {
      EXPECT_NEAR(section.changes[k].area, drawing.areas[k], 1e-9 * drawing.areas[k] + faults) << k;
    }
  }
  const Real moved =
      section.snaps.largest + section.simplified.largest + section.simplified.area_move + section.snaps.largest;
  EXPECT_LT(moved, options.shortest_edge + options.tolerance + 4 * options.snap);
  Random random(GetParam() + 1000);
  for (int k = 0; k < 400; ++k) {
    const Vec<2> x{random.between(0, 100), random.between(0, 26)};
    const auto found = regions_at(section, x);
    EXPECT_LE(found.size(), 1u) << x[0] << ' ' << x[1];
    const auto drawn = drawn_at(drawing, x, moved + 1e-6);
    if (drawn) {
      EXPECT_EQ(found.empty() ? -1 : found[0], *drawn) << x[0] << ' ' << x[1];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, UnpleasantSection, testing::Range(0, 100));

TEST(CleanRegions, SimplifyALaserScanWithinTheTolerance)
{
  Random random(7);
  Polygon outline{{0, 0}, {200, 0}};
  for (int k = 700; k >= 0; --k) {
    const Real x = 200.0 * k / 700.0;
    const Real ground = 5.0 + std::clamp(3.0 - std::abs(x - 100.0) / 3.0, 0.0, 2.5);
    outline.push_back({x, std::round((ground + random.between(-0.01, 0.01)) * 1e3) / 1e3});
  }
  const auto section = clean_regions({{"dike", outline}}, {}, {});
  EXPECT_LT(section.corners, 60);
  EXPECT_LE(section.simplified.largest, 0.0201);
  EXPECT_NEAR(section.changes[0].area, signed_area(outline), 1e-10 * signed_area(outline));
  EXPECT_EQ(section.regions[0].polygon[0][0] * 0.0, 0.0);
}

}  // namespace clean_regions_test
