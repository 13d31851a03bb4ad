#include "run/measure/crest.hpp"
#include "mpm/mesh/mesh.hpp"
#include "support/blocks.hpp"

namespace crest_test {

/// A time [s] and the place of the crest there [m].
using Places = std::vector<std::pair<Real, Real>>;

/// Goes on in rows of 0.01 s, the crest on straight lines from place to place, in whole columns.
CrestHistory gone_on(CrestHistory crest, const Places& places)
{
  for (const auto& [time, x] : places) {
    if (crest.time.empty()) {
      crest.time.push_back(0.0);
      crest.x.push_back(x);
    }
    const Real t_0 = crest.time.back(), x_0 = crest.x.back();
    const int n = static_cast<int>(std::lround((time - t_0) / 0.01));
    for (int k = 1; k <= n; ++k) {
      crest.time.push_back(t_0 + 0.01 * k);
      crest.x.push_back(0.1 * std::round(10.0 * (x_0 + (x - x_0) * k / n)));
    }
  }
  return crest;
}

/// On a flat surface of columns of 0.1 m over 8 m, 2 m high: a slide is a retreat of 0.5 m.
CrestHistory history(const Places& places, Real width = 0.1, Real height = 1.92)
{
  return gone_on({.slope = {.facing = Facing::right, .first = 0, .last = 80, .height = height},
                     .width = width,
                     .time = {},
                     .x = {},
                     .kinetic = {}},
      places);
}

/// First slide from 0.3 s to 0.7 s, then rest to 2 s, then as `places` say.
CrestHistory after_first_slide(const Places& places)
{
  return gone_on(history({{0.3, 8.0}, {0.7, 6.0}, {2.0, 6.0}}), places);
}

TEST(SecondFailure, IsTheTimeAtWhichTheSettledCrestBeginsToSlideAgain)
{
  const CrestHistory crest = after_first_slide({{2.3, 4.5}, {4.0, 4.5}});
  ASSERT_TRUE(second_failure_time(crest).has_value());
  EXPECT_NEAR(*second_failure_time(crest), 2.0, 0.05);  // in whole columns, of which the first is within the tolerance
}

TEST(SecondFailure, IsSeenInRowsThatAreRare)
{
  CrestHistory crest = history({});
  for (const auto& [time, x] :
      {std::pair(0.0, 8.0), {0.5, 8.0}, {1.0, 6.0}, {1.5, 6.0}, {2.0, 6.0}, {2.5, 4.5}, {3.0, 4.5}})
    crest.time.push_back(time), crest.x.push_back(x);
  ASSERT_TRUE(second_failure_time(crest).has_value());
  EXPECT_DOUBLE_EQ(*second_failure_time(crest), 2.5);
}

TEST(Slides, BeginWhenTheCrestLeavesForGoodNotWhenItFlickers)
{
  const CrestHistory crest = history({
      {0.5, 8.0},
      {0.51, 6.5},
      {0.65, 6.5},
      {0.66, 8.0},  // back within 0.3 s
      {0.8, 8.0},
      {1.0, 6.0},
      {2.0, 6.0},
  });
  const auto slides = find_slides(crest);
  ASSERT_EQ(slides.size(), 1);
  EXPECT_NEAR(slides[0].begins, 0.82, 0.011);
  EXPECT_EQ(slides[0].crest_from, 8.0);
  EXPECT_NEAR(slides[0].crest_to, 6.0, 1e-12);
}

TEST(Slides, TheNextBeginsWithTheCrestAtWhichTheOneBeforeEnded)
{
  const CrestHistory crest = after_first_slide({
      {3.0, 5.9},  // creeps on by a column
      {3.3, 4.5},
      {4.0, 4.4},
  });
  const auto slides = find_slides(crest);
  ASSERT_EQ(slides.size(), 2);
  EXPECT_EQ(slides[0].crest_to, slides[1].crest_from);
  EXPECT_NEAR(slides[0].crest_to, 5.9, 0.101);
  EXPECT_NEAR(slides[1].crest_to, 4.4, 1e-12);  // where it stands at the end
}

/// Kinetic energy over the rows: straight lines between these values at these times.
void move_with(CrestHistory& crest, const std::vector<std::pair<Real, Real>>& corners)
{
  for (const Real t : crest.time) {
    std::size_t k = 1;
    while (k + 1 < corners.size() && corners[k].first < t) ++k;
    const auto [t_0, e_0] = corners[k - 1];
    const auto [t_1, e_1] = corners[k];
    crest.kinetic.push_back(e_0 + (e_1 - e_0) * (t - t_0) / (t_1 - t_0));
  }
}

TEST(Slides, EachBeginsWhenTheCrestLeavesItsPlaceAndStopsWhenATenthOfItsEnergyIsLeft)
{
  CrestHistory crest = after_first_slide({{2.3, 4.5}, {4.0, 4.5}});
  move_with(crest, {{0.0, 0.0}, {0.5, 100.0}, {1.5, 0.0}, {2.0, 0.0}, {2.5, 50.0}, {4.0, 20.0}});
  const auto slides = find_slides(crest);
  ASSERT_EQ(slides.size(), 2);
  EXPECT_NEAR(slides[0].begins, 0.34, 1e-9);  // 0.2 m back: more than the tolerance of one column
  EXPECT_EQ(slides[0].crest_from, 8.0);
  EXPECT_NEAR(slides[0].crest_to, 6.0, 0.11);
  EXPECT_NEAR(slides[0].kinetic_peak, 100.0, 1e-9);
  ASSERT_TRUE(slides[0].stops.has_value());
  EXPECT_NEAR(*slides[0].stops, 1.4, 0.011);
  EXPECT_EQ(slides[1].begins, *second_failure_time(crest));
  EXPECT_NEAR(slides[1].crest_to, 4.5, 0.11);
  EXPECT_NEAR(slides[1].kinetic_peak, 50.0, 1e-9);
  EXPECT_FALSE(slides[1].stops.has_value());  // 20 of 50 are left at the end
}

TEST(Slides, AreAsManyAsTheCrestMakes)
{
  EXPECT_THAT(find_slides(after_first_slide({{2.3, 4.5}, {3.5, 4.5}, {3.8, 3.0}, {5.0, 3.0}, {5.3, 1.5}, {6.5, 1.5}})),
      SizeIs(4));
}

TEST(Slides, AreNoneWhereTheCrestStands)
{
  EXPECT_THAT(find_slides(history({})), IsEmpty());
  EXPECT_THAT(find_slides(history({{2.0, 8.0}})), IsEmpty());
  EXPECT_THAT(find_slides(history({{2.0, 8.0}, {2.1, 7.6}})), IsEmpty());  // less than a quarter of the height
}

TEST(Slides, StopNowhereWithoutEnergies)
{
  const auto slides = find_slides(after_first_slide({}));
  ASSERT_EQ(slides.size(), 1);
  EXPECT_FALSE(slides[0].stops.has_value());
}

TEST(SecondFailure, IsASlideOfACrestThatHasSettledAfterTheFirst)
{
  struct Row {
    const char* what;
    bool fails_twice;
    CrestHistory crest;
  };
  const Row rows[] = {
      {"no rows", false, history({})},
      {"no slide", false, history({{2.0, 8.0}})},
      {"creep, then rest", false, history({{2.0, 8.0}, {3.0, 7.7}, {5.0, 7.7}})},
      {"never rests for 0.3 s", false, history({{0.3, 8.0}, {3.0, 1.0}})},
      {"rests too short: still the first", false,
          history({{0.3, 8.0}, {0.7, 6.0}, {0.9, 6.0}, {1.1, 4.5}, {4.0, 4.5}})},
      {"creeps by 1.5 m over 2 s: 0.23 m in any 0.3 s", false, after_first_slide({{4.0, 4.5}})},
      {"creeps, then leaves the settled place", true, after_first_slide({{3.0, 5.8}, {3.2, 4.6}})},
      {"less than a quarter of the height", false, after_first_slide({{2.1, 5.6}, {4.0, 5.6}})},
      {"more than a quarter of the height", true, after_first_slide({{2.1, 5.4}, {4.0, 5.4}})},
      // On coarse cells one column may be creep: the rest must be longer.
      {"coarse, 0.55 s of rest", false, history({{0.3, 8.0}, {0.4, 6.0}, {0.95, 6.0}, {1.05, 4.6}, {4.0, 4.6}}, 0.2)},
      {"coarse, 0.7 s of rest", true, history({{0.3, 8.0}, {0.4, 6.0}, {1.1, 6.0}, {1.2, 4.6}, {4.0, 4.6}}, 0.2)},
      // On fine cells creep may be more than a column, by 0.1 m every 0.27 s: not more than a twentieth of the height.
      {"fine", true, history({{0.3, 8.0}, {0.4, 6.0}, {2.0, 5.4}, {2.1, 4.6}, {4.0, 4.6}}, 0.05, 2.0)},
  };
  for (const Row& row : rows) EXPECT_EQ(second_failure_time(row.crest).has_value(), row.fails_twice) << row.what;
}

/// Times at which the crest of model 1 on cells of 0.2 m leaves its column [s], from 7.0 m on in steps of 0.2 m.
const std::vector<Real> soft_column = {0.22, 0.23, 0.25, 0.27, 0.29, 0.32, 0.36, 0.41, 0.47, 0.56, 0.69, 0.84, 1.01,
    1.16, 1.26, 1.33, 1.39, 1.45, 1.52, 1.60, 1.70, 1.81, 1.93, 2.05, 2.17, 2.27, 2.37, 2.46, 2.55, 2.63, 2.72, 2.79,
    2.85};

TEST(SecondFailure, IsNotTheCreepOfAColumnOnCoarseCells)
{
  CrestHistory crest = history({}, 0.2);
  for (int k = 0; k <= 400; ++k) {
    crest.time.push_back(0.01 * k);
    Real x = 8.0;
    for (std::size_t n = 0; n < soft_column.size(); ++n)
      if (soft_column[n] <= crest.time.back() + 1e-9) x = 6.8 - 0.2 * static_cast<Real>(n);
    crest.x.push_back(x);
  }
  EXPECT_FALSE(second_failure_time(crest).has_value());  // it creeps on at 0.7 m/s and more: it has not settled
}

const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 2.0}, {8, 4});

/// Two rows of points, eight columns of 0.5 m, heights by column.
PointBlocks<2> ground(const std::vector<Real>& heights)
{
  PointBlocks<2> points(mesh.n_cells(), 0);
  for (std::size_t k = 0; k < heights.size(); ++k)
    for (const Real y : {0.1, heights[k]}) {
      const Location at = locate(mesh, {0.25 + 0.5 * static_cast<Real>(k), y}, 0);
      add_point(mesh, at.cell, {.local = at.local}, points);
    }
  points.update_occupied();
  return points;
}

const Columns eight{.left = 0.0, .width = 0.5, .n = 8};

/// The crests of the slopes of a section when its surface has become that of `now`.
std::vector<Real> crests(const std::vector<Real>& first, const std::vector<Real>& now)
{
  const Section section = look_at_section(mesh, ground(first), eight);
  const auto slopes = find_slopes(section);
  std::vector<Real> x;
  for (const Slope& slope : slopes)
    x.push_back(find_crest(
        section, slope, find_standing(section, slope, slopes.size() == 1, surface_heights(mesh, ground(now), eight))));
  return x;
}

TEST(Crest, StartsAtTheRightEdgeOfTheBody)
{
  const Section section = look_at_section(mesh, ground({1.5, 1.5, 1.5, 1.5}), eight);
  const auto slopes = find_slopes(section);
  ASSERT_EQ(slopes.size(), 1);
  const Standing standing = find_standing(section, slopes[0], true, section.heights);
  EXPECT_EQ(find_crest(section, slopes[0], standing), 2.0);
  EXPECT_EQ(crest_height(section, slopes[0], standing, section.heights), 1.5);
  EXPECT_TRUE(std::isnan(crest_height(section, slopes[0], {}, section.heights)));
  EXPECT_EQ(back_of(section, slopes[0]), 0.0);
}

TEST(Crest, IsTheLastColumnToWhoseLeftAllStandWithinFiveCentimetres)
{
  const std::vector<Real> flat{1.5, 1.5, 1.5, 1.5};
  EXPECT_THAT(crests(flat, {1.5, 1.46, 1.54, 1.44}), ElementsAre(1.5));
  EXPECT_THAT(crests(flat, {1.5, 1.44, 1.5, 1.5}), ElementsAre(0.5));  // what stands beyond a gap does not count
  EXPECT_THAT(crests(flat, {1.56, 1.5, 1.5, 1.5}), ElementsAre(testing::IsNan()));  // heave is motion too
  EXPECT_THAT(crests(flat, {1.5, 1.5, 1.5, 1.5, 1.5}), ElementsAre(2.0));  // soil that came later has no first height
}

TEST(Crest, OfASlopeThatFallsToTheLeftIsTheMirrorImage)
{
  const std::vector<Real> flat{0.2, 0.2, 0.2, 0.2, 1.5, 1.5, 1.5, 1.5};
  EXPECT_THAT(crests(flat, flat), ElementsAre(2.0));
  EXPECT_THAT(crests(flat, {0.2, 0.2, 0.2, 0.2, 1.44, 1.5, 1.5, 1.5}), ElementsAre(2.5));
  EXPECT_THAT(crests(flat, {0.2, 0.2, 0.2, 0.2, 1.5, 1.5, 1.44, 1.5}), ElementsAre(3.5));
}

TEST(Crest, OfASlopeBelowItsEdgeIsTheEdge)  // the face of the slope stands too
{
  const std::vector<Real> slope{1.5, 1.5, 1.5, 1.2, 0.8, 0.4, 0.4, 0.4};
  EXPECT_THAT(crests(slope, slope), ElementsAre(1.5));
  EXPECT_THAT(crests(slope, {1.5, 1.5, 1.4, 1.2, 0.8, 0.4, 0.4, 0.4}), ElementsAre(1.0));
}

TEST(Crest, OfADikeIsThatOfTheHighestGroundThatStands)
{
  const std::vector<Real> dike{0.2, 0.8, 1.5, 1.5, 1.5, 0.8, 0.2, 0.2};
  EXPECT_THAT(crests(dike, dike), ElementsAre(2.5, 1.0));  // to the right, to the left
  EXPECT_THAT(crests(dike, {0.2, 0.8, 1.5, 1.5, 1.3, 0.9, 0.3, 0.2}), ElementsAre(2.0, 1.0));
  EXPECT_THAT(crests(dike, {0.3, 0.9, 1.3, 1.5, 1.5, 0.8, 0.2, 0.2}), ElementsAre(2.5, 1.5));
  EXPECT_THAT(crests(dike, {0.2, 0.8, 1.2, 1.0, 0.9, 0.9, 0.4, 0.3}),
      ElementsAre(1.0, testing::IsNan()));  // only the outer slope is left
}

TEST(Crest, OfAMirroredDikeIsTheMirrorImageWhateverStands)
{
  const std::vector<Real> dike{0.2, 0.8, 1.5, 1.5, 1.5, 1.5, 0.8, 0.2};
  const std::vector<Real> loose{0.2, 0.8, 1.2, 1.5, 0.9, 1.5, 1.1, 0.4}, gone{0.2, 0.8, 1.2, 1.0, 0.9, 1.1, 0.8, 0.2};
  for (const auto& now : {loose, gone}) {
    const auto a = crests(dike, now), b = crests(dike, {now.rbegin(), now.rend()});
    EXPECT_EQ(a[0], 4.0 - b[1]);
    EXPECT_EQ(a[1], 4.0 - b[0]);
  }
}

TEST(Slides, OfAMirroredCrestAreMirrored)
{
  const CrestHistory right = after_first_slide({{2.3, 4.5}, {4.0, 4.5}});
  CrestHistory left = right;
  left.slope.facing = Facing::left;
  for (Real& x : left.x) x = 16.0 - x;
  const auto a = find_slides(right), b = find_slides(left);
  ASSERT_EQ(a.size(), 2);
  ASSERT_EQ(b.size(), 2);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(a[k].begins, b[k].begins);
    EXPECT_NEAR(a[k].crest_to, 16.0 - b[k].crest_to, 1e-12);
    EXPECT_EQ(b[k].facing, Facing::left);
  }
}

}  // namespace crest_test
