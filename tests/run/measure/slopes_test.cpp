#include "run/measure/flood_dike.hpp"
#include "support/stages.hpp"

namespace slopes_test {

/// The column for a time, with a row of the ledger every 0.02 s.
struct Collapse : Simulation {
  std::vector<TableRow> rows;

  explicit Collapse(Real end, const Case& description = column("mpm_gp", 0.25));
};

Collapse::Collapse(Real end, const Case& description) : Simulation(description, 1, all_followers())
{
  Simulation& s = *this;
  for (Real next = 0.0; s.state.time < end; next += 0.02) {
    while (s.state.time < next) make_steps(s);
    rows.push_back(keep_ledger(s.model, s.state, s.work));
  }
}

TEST(Slopes, OfTheColumnIsASlideWithASlipSurfaceFromTheCrestToTheToe)
{
  const Collapse s(1.2);
  const Summary summary = summarise(s.model, s.state);
  ASSERT_EQ(summary.slides.size(), 1);
  const auto& [slide, slip, onset, stage] = summary.slides[0];
  EXPECT_EQ(stage, "") << "the run has none";
  EXPECT_GT(slide.begins, 0.1);
  EXPECT_LT(slide.begins, 0.3);
  EXPECT_EQ(slide.crest_from, 8.0);
  EXPECT_LT(slide.crest_to, 7.5);
  EXPECT_GT(slip.time, slide.begins);
  EXPECT_GE(onset.time, slide.begins);
  EXPECT_LE(onset.time, slip.time);
  EXPECT_GT(onset.line.size(), 4);
  ASSERT_GT(slip.line.size(), 8);
  EXPECT_GT(slip.line.front()[1], 1.0);  // up at the crest
  EXPECT_LT(slip.line.back()[1], 0.3);   // down at the base
  EXPECT_LT(slip.line.front()[0], 7.0);
  EXPECT_GT(slip.line.back()[0], 8.0);
}

// Each stage has a slide of its own: the second begins in the section that the first has left.
TEST(Slopes, OfEarlierStagesStayInTheList)
{
  Case c = column("mpm_gp", 0.25);
  c.output.ledger_every = 0.02;
  StageCase weaker = stage("weaker", 0.8);
  weaker.reset_displacement = true;
  const Case chain =
      staged(c, {{stage("first", 1.2), {}},
                    {weaker, [](Case& n) { n.materials = {clay({.su_peak = 3e3, .su_residual = 500.0})}; }}});
  Simulation s(chain, 1, all_followers());
  while (s.state.stages_done.empty()) s.step(1);
  const Summary first = summarise(s.model, s.state);
  ASSERT_EQ(first.slides.size(), 1);
  s.run();
  Summary all = summarise(s.model, s.state);
  ASSERT_EQ(all.slides.size(), 2);
  EXPECT_EQ(all.slides[0].stage, "first");
  EXPECT_EQ(all.slides[1].stage, "weaker");
  EXPECT_EQ(all.first_slide_time, all.slides[0].slide.begins);
  EXPECT_EQ(all.slides[0].slide.begins, first.slides[0].slide.begins);
  EXPECT_EQ(all.slides[0].slip.line, first.slides[0].slip.line);
  EXPECT_GT(all.slides[1].slide.begins, 1.2);
  Simulation resumed(chain, 1, all_followers());
  resumed.restore(s.save());
  const Summary again = summarise(resumed.model, resumed.state);
  ASSERT_EQ(again.slides.size(), 2);
  EXPECT_EQ(again.slides[0].slip.line, all.slides[0].slip.line);
  EXPECT_EQ(again.slides[0].slide.stops, all.slides[0].slide.stops);
  EXPECT_EQ(again.slides[0].slide.crest_to, all.slides[0].slide.crest_to);
  EXPECT_EQ(again.slides[0].stage, "first");
}

/// The column at the left wall, or at the right wall, where it falls to the left. Of 5 x 5 points the middle ones lie
/// between two sub-cells and belong to the one on the right, so that the mirror image differs by 1e-5 of its energy at
/// once; of 4 x 4 points it does not (decision 0007). Without local damping, which acts by the sign of a velocity, also
/// of one that is round-off: with 0.1 of it the fronts differ by 1 cm at 0.6 s.
Case column_at(Facing facing)
{
  Case c = column("mpm_gp", 0.25);
  if (facing == Facing::left) c.bodies = {body("clay", {8.0, 0.0}, {16.0, 2.0})};
  c.bodies[0].points_per_cell = {4, 4};
  c.forces.local_damping = 0.0;
  return c;
}

TEST(Slopes, OfTheMirroredColumnIsTheMirrorImage)
{
  const Collapse right(0.6, column_at(Facing::right)), left(0.6, column_at(Facing::left));
  const Summary a = summarise(right.model, right.state), b = summarise(left.model, left.state);
  EXPECT_EQ(b.facing, Facing::left);
  EXPECT_TRUE(b.free_toe);
  EXPECT_GT(a.front_x, 8.2);
  EXPECT_NEAR(b.front_x, 16.0 - a.front_x, 1e-9);
  EXPECT_NEAR(b.run_out, a.run_out, 1e-9);
  EXPECT_NEAR(*b.crest_x, 16.0 - *a.crest_x, 1e-9);
  EXPECT_NEAR(b.moved_volume, a.moved_volume, 1e-9);
  EXPECT_NEAR(*b.intact_fraction, *a.intact_fraction, 1e-9);
  ASSERT_EQ(b.slides.size(), 1);
  EXPECT_EQ(b.slides[0].slide.facing, Facing::left);
  EXPECT_NEAR(b.slides[0].slide.begins, a.slides[0].slide.begins, 1e-9);
  EXPECT_EQ(b.slides[0].slide.crest_from, 8.0);
  EXPECT_GT(b.slides[0].slip.line.back()[1], 1.0);  // up at the crest
  EXPECT_LT(b.slides[0].slip.line.front()[1], 0.3);
  for (std::size_t k = 0; k < left.rows.size(); ++k) {
    EXPECT_TRUE(std::isnan(left.rows[k]["front_x"]));
    EXPECT_NEAR(left.rows[k]["crest_left_x"], 16.0 - right.rows[k]["crest_x"], 1e-9);
  }
}

/// A slope of 2 m on ground of 1 m that fills the mesh to both sides.
Case slope_on_ground()
{
  Case c = column("mpm_gp", 0.25);
  BodyCase slope = body("clay", {0.0, 0.0}, {16.0, 1.0});
  slope.polygon = {{0.0, 0.0}, {16.0, 0.0}, {16.0, 1.0}, {9.0, 1.0}, {7.0, 3.0}, {0.0, 3.0}};
  c.mesh.size = {16.0, 4.0};
  c.bodies = {slope};
  return c;
}

TEST(Slopes, OfASlopeOnGroundHasTheFrontOfTheSoilThatMoved)
{
  const Collapse s(1.0, slope_on_ground());
  EXPECT_TRUE(std::isnan(s.rows.front()["front_x"]));  // nothing moved yet; not the side of the mesh
  EXPECT_NEAR(s.rows.front()["crest_x"], 7.0, 0.3);    // not the side of the mesh either
  const Summary summary = summarise(s.model, s.state);
  EXPECT_FALSE(summary.free_toe);
  EXPECT_GT(summary.front_x, 8.0);
  EXPECT_LT(summary.front_x, 15.0);
  EXPECT_NEAR(summary.run_out, std::max(0.0, summary.front_x - 9.0), 0.3);
  ASSERT_FALSE(summary.slides.empty());
  EXPECT_NEAR(summary.slides[0].slide.crest_from, 7.0, 0.3);
}

/// An embankment of 3 m on ground of 1 m, the same to both sides.
Case embankment()
{
  Case c = column("mpm_gp", 0.5);
  BodyCase body = test::body("clay", {0.0, 0.0}, {24.0, 1.0});
  body.polygon = {{0.0, 0.0}, {24.0, 0.0}, {24.0, 1.0}, {17.0, 1.0}, {15.0, 4.0}, {9.0, 4.0}, {7.0, 1.0}, {0.0, 1.0}};
  body.points_per_cell = {4, 4};
  c.mesh.size = {24.0, 5.0};
  c.bodies = {body};
  c.materials = {clay({.su_peak = 12.0e3})};
  c.sides[2] = side("bottom", SideKind::fixed);
  return c;
}

TEST(Slopes, OfASymmetricEmbankmentIsASlideToEachSide)
{
  const Collapse s(0.8, embankment());
  const Summary summary = summarise(s.model, s.state);
  ASSERT_EQ(summary.slides.size(), 2);
  const Slide &a = summary.slides[0].slide, &b = summary.slides[1].slide;
  EXPECT_EQ(a.facing, Facing::right);
  EXPECT_EQ(b.facing, Facing::left);
  EXPECT_EQ(a.begins, b.begins);
  EXPECT_NEAR(a.crest_from, 24.0 - b.crest_from, 1e-9);
  EXPECT_NEAR(a.crest_to, 24.0 - b.crest_to, 1e-9);
  EXPECT_EQ(summary.facing, Facing::right);      // both came equally far
  for (const SlideSummary& of : summary.slides)  // each has the soil that goes its way, from the middle on
    for (const SlipSurface* slip : {&of.slip, &of.onset}) {
      ASSERT_GT(slip->line.size(), 4u);
      for (const Vec<2>& x : slip->line) EXPECT_GT(outwards(of.slide.facing) * (x[0] - 12.0), -0.5) << slip->time;
    }
  const TableRow& last = s.rows.back();
  EXPECT_NEAR(last["front_x"], 24.0 - last["front_left_x"], 1e-3);
  EXPECT_GT(last["front_x"], 17.0);
}

TEST(Slopes, SoilThatLeavesThroughAnOpenSideHasMoved)
{
  Case c = free_box("mpm_gp", {2.0, 0.0}, {3.0, 1.0});  // of 1 m^2, 1 m from the side
  c.bodies[0].velocity = {10.0, 0.0};
  c.sides.push_back(side("right", SideKind::open));
  const Collapse s(0.15, c);
  for (std::size_t k = 1; k < s.rows.size(); ++k)
    EXPECT_GE(s.rows[k]["moved_volume"], s.rows[k - 1]["moved_volume"] - 1e-9);
  const auto n_left = static_cast<Real>(s.state.left.size()), n = static_cast<Real>(s.state.n_ids());
  EXPECT_NEAR(n_left / n, 0.5, 0.1);
  EXPECT_NEAR(s.rows.back()["moved_volume"], 1.0, 1e-9);
  const Summary summary = summarise(s.model, s.state);
  EXPECT_NEAR(summary.moved_volume, 1.0, 1e-9);
  EXPECT_NEAR(summary.moved_fraction, 1.0, 1e-12);
}

TEST(Slopes, MovedSoilAndRunOutGrowFromNothing)
{
  const Collapse s(0.8);
  const auto& rows = s.rows;
  EXPECT_EQ(rows.front()["moved_volume"], 0.0);
  EXPECT_EQ(rows.front()["crest_x"], 8.0);
  EXPECT_NEAR(rows.front()["crest_y"], 1.975, 1e-12);
  for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_GE(rows[k]["moved_volume"], rows[k - 1]["moved_volume"] - 0.05);
  const Summary summary = summarise(s.model, s.state);
  EXPECT_NEAR(summary.moved_distance, 1.95 / 20.0, 1e-12);
  EXPECT_DOUBLE_EQ(summary.moved_volume, rows.back()["moved_volume"]);
  EXPECT_NEAR(summary.moved_fraction, summary.moved_volume / 16.0, 1e-3);
  EXPECT_GT(summary.moved_fraction, 0.1);
  EXPECT_NEAR(summary.run_out, rows.back()["front_x"] - rows.front()["front_x"], 1e-12);
}

TEST(Slopes, TheSlipSurfaceIsOfTheTimeAtWhichTheStrainGrewFastest)
{
  Collapse s(0.5);
  const auto slip = [&] { return array_of(s.state, "followers/slopes/slope_0/slip_surfaces"); };
  const auto line = [&] { return array_of(s.state, "followers/slopes/slope_0/slip_places"); };
  const auto before = slip(), places = line();
  ASSERT_EQ(before.size(), 3u);
  EXPECT_GT(before[1], 0.0);  // the rate
  EXPECT_FALSE(places.empty());
  s.state.time += 0.02;
  keep_ledger(s.model, s.state, s.work);  // nothing grew
  EXPECT_EQ(slip(), before);
  EXPECT_EQ(line(), places);
}

TEST(Slopes, SoilThatRestsHasNone)
{
  Case c = column("mpm_gp", 0.5);
  c.forces.gravity = {0.0, 0.0};
  Simulation s = followed(c);
  for (int k = 0; k < 3; ++k) {
    keep_ledger(s.model, s.state, s.work);
    make_steps(s, 5);
  }
  const Summary summary = summarise(s.model, s.state);
  EXPECT_TRUE(summary.slides.empty());
  EXPECT_EQ(summary.moved_volume, 0.0);
  EXPECT_NEAR(summary.run_out, 0.0, 1e-12);
  EXPECT_FALSE(summary.second_failure_time.has_value());
}

std::vector<Slide> slides_of(const Drawn& s)
{
  std::vector<Slide> list;
  for (const SlideSummary& slide : summarise(s.model, s.state).slides) list.push_back(slide.slide);
  return list;
}

/// Soil above 1 m that lies beyond x slides out by 6 m and lies flat.
Vec<2> slid(Vec<2> p, bool lies_beyond, Real out)
{
  return p[1] > 1.0 && lies_beyond ? Vec<2>{p[0] + out, 1.0 + 0.1 * (p[1] - 1.0)} : p;
}

TEST(Slopes, ADikeThatFailsToBothSidesHasASlideToEach)
{
  Drawn s(embankment());  // its crest is from 9 m to 15 m
  s.become([](Vec<2> p) { return p; });
  const auto right = [](Vec<2> p) { return slid(p, p[0] > 12.0, 6.0); };
  s.become(right);
  s.become([&](Vec<2> p) { return p[0] < 12.0 ? slid(p, true, -6.0) : right(p); });  // nothing of the crest stands
  s.become([&](Vec<2> p) { return p[0] < 12.0 ? slid(p, true, -6.2) : slid(p, true, 6.2); });
  const auto slides = slides_of(s);
  ASSERT_EQ(slides.size(), 2u);
  EXPECT_EQ(slides[0].facing, Facing::right);
  EXPECT_NEAR(slides[0].begins, 2.5, 1e-9);
  EXPECT_NEAR(slides[0].crest_to, 12.0, 0.51);
  EXPECT_EQ(slides[1].facing, Facing::left);
  EXPECT_NEAR(slides[1].begins, 4.9, 1e-9);
  EXPECT_NEAR(slides[1].crest_from, 9.0, 0.51);
}

TEST(Slopes, WhatTheOtherSlopeTakesIsNoSlide)
{
  Drawn s(embankment());
  s.become([](Vec<2> p) { return slid(p, p[0] > 12.0, 6.0); });
  s.become([](Vec<2> p) { return slid(p, p[0] > 8.0, 6.0); });  // to the right too, all of the crest
  s.become([](Vec<2> p) { return p[0] < 8.0 && p[1] > 1.0 ? Vec<2>{p[0] - 0.5, p[1]} : slid(p, true, 6.0); });
  for (const Slide& slide : slides_of(s)) EXPECT_EQ(slide.facing, Facing::right) << slide.begins;
  EXPECT_EQ(slides_of(s).size(), 2u);
}

/// A plateau that falls from 8 m at the left wall to 5 m at x = 40 m, and a slope of 1:2 to ground of 1 m.
Case plateau()
{
  Case c = column("mpm_gp", 0.5);
  BodyCase soil = body("clay", {0.0, 0.0}, {80.0, 1.0});
  soil.polygon = {{0.0, 0.0}, {80.0, 0.0}, {80.0, 1.0}, {48.0, 1.0}, {40.0, 5.0}, {0.0, 8.0}};
  soil.points_per_cell = {4, 4};
  c.mesh.size = {80.0, 9.0};
  c.bodies = {soil};
  return c;
}

TEST(Slopes, APlateauThatFallsGentlySlidesFromItsEdge)
{
  Drawn s(plateau());
  s.become([](Vec<2> p) { return p; });
  s.become([](Vec<2> p) { return slid(p, p[0] > 35.0, 8.0); });
  s.become([](Vec<2> p) { return slid(p, p[0] > 28.0, 12.0); });
  const auto slides = slides_of(s);
  ASSERT_EQ(slides.size(), 2u);
  EXPECT_NEAR(slides[0].begins, 2.5, 1e-9);
  EXPECT_NEAR(slides[0].crest_from, 40.0, 1.01);
  EXPECT_NEAR(slides[0].crest_to, 35.0, 0.51);
  EXPECT_NEAR(slides[1].begins, 4.9, 1e-9);
  EXPECT_NEAR(slides[1].crest_to, 28.0, 0.51);
}

}  // namespace slopes_test
