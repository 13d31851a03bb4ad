#include "mpm/step/workspace.hpp"
#include "run/rest/equilibrium.hpp"
#include "run/rest/no_equilibrium.hpp"
#include "support/simulations.hpp"

namespace equilibrium_test {

std::string seek(Simulation& s, bool stopped = false)
{
  return find_equilibrium(s.model, s.state, std::atomic<bool>{stopped}).fault;
}

/// The column on a fixed base, of which the strength is so many times what it needs.
Case standing_column(Real strength)
{
  Case c = column_without_softening("mpm_gp", 0.25);
  c.sides[2].kind = SideKind::fixed;
  c.materials = {clay({.su_peak = strength * 8.0e3, .su_residual = strength * 8.0e3})};
  c.initial.stress = InitialStress::equilibrium;
  return c;
}

/// Largest and mean difference of the shear stress of two states over its root mean square [-].
std::array<Real, 2> difference_in_shear(const State& a, const State& b)
{
  Real largest = 0.0, square = 0.0, of_a = 0.0;
  const auto points = points_by_id(a), others = points_by_id(b);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Real d = points[k].sigma[3] - others[k].sigma[3];
    largest = std::max(largest, std::abs(d));
    square += d * d, of_a += points[k].sigma[3] * points[k].sigma[3];
  }
  return {largest / std::sqrt(of_a / static_cast<Real>(points.size())), std::sqrt(square / of_a)};
}

TEST(Equilibrium, ItChangesTheStressToThatAtRestAndNothingElse)
{
  Case c = confined_box(InitialStress::equilibrium);
  const Simulation drawn(c);
  Simulation s(c);
  ASSERT_EQ(seek(s), "");
  EXPECT_GT(s.state.equilibrium_steps, 10);
  const auto before = points_by_id(drawn.state), after = points_by_id(s.state);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(after[k].x, before[k].x);
    EXPECT_EQ(after[k].local, before[k].local);
    EXPECT_EQ(after[k].volume, before[k].volume);
    EXPECT_EQ(after[k].v, (Vec<2>{0.0, 0.0}));
    EXPECT_EQ(after[k].strain, (std::array<Real, 4>{}));
    EXPECT_NE(after[k].sigma, before[k].sigma);
  }
  EXPECT_EQ(s.state.x_initial, drawn.state.x_initial);
  EXPECT_EQ(s.state.step, 0);
  EXPECT_EQ(s.state.time, 0.0);
  EXPECT_EQ(s.state.work.gravity, 0.0);
  std::vector<Vec<2>> mean(s.model.mesh->cells.size(), {0.0, 0.0});  // stress xx, yy of each cell [Pa]
  for (const Point& p : after)
    for (int k = 0; k < 2; ++k) mean[p.cell][k] += p.sigma[k] / 25.0;
  for (Index cell = 0; cell < 6 * 16; ++cell) {
    const Real vertical = -2000.0 * 9.81 * (1.5 - s.model.mesh->centres[cell][1]);
    EXPECT_NEAR(mean[cell][1], vertical, 0.001 * 2000.0 * 9.81 * 1.5);
    EXPECT_NEAR(mean[cell][0], 0.3 / 0.7 * vertical, 0.001 * 2000.0 * 9.81 * 1.5);  // nu / (1 - nu), confined
  }
  s.step();
  EXPECT_LE(s.work.unbalanced_ratio, 2e-4);
}

TEST(Equilibrium, PlasticStrainBeginsAtZero)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.materials = {clay({.poisson_ratio = 0.3, .su_peak = 5e3, .su_residual = 5e3})};
  c.bodies[0].material = "clay";
  Simulation s = followed(c);
  s.start();  // seeks, then audits
  for (const Point& p : points_by_id(s.state)) EXPECT_EQ(p.eps_eq_p(), 0.0);
  for (const Real eps : array_of(s.state, "followers/history_audit/last_eps_eq_p")) EXPECT_EQ(eps, 0.0);
}

TEST(Equilibrium, SoilThatYieldsDoesNotSoften)
{
  Case c = standing_column(1.2), softens = c;
  softens.materials = {clay({.su_peak = 1.2 * 8.0e3, .su_residual = 1.2 * 2.0e3, .eta = 50.0})};
  Simulation s(c), t(softens);
  ASSERT_EQ(seek(s), "");
  ASSERT_EQ(seek(t), "");
  EXPECT_LT(difference_in_shear(s.state, t.state)[1], 0.005);
}

TEST(Equilibrium, TheShearStressDoesNotDependOnTheDampingOfTheSearch)
{
  Case c = standing_column(1.2);
  Simulation s(c);
  ASSERT_EQ(seek(s), "");
  for (const Real damping : {0.0, 0.5, 0.8}) {
    c.initial.damping = damping;
    Simulation t(c);
    ASSERT_EQ(seek(t), "");
    EXPECT_LT(difference_in_shear(s.state, t.state)[1], 0.03) << damping;
  }
}

TEST(Equilibrium, AColumnThatCannotStandIsRefused)
{
  Case c = column("mpm_gp", 0.25);
  c.initial.stress = InitialStress::equilibrium;
  Simulation s(c);
  EXPECT_THAT(seek(s),
      MatchesRegex(
          "no equilibrium: the soil fails in the section as it is drawn; after [0-9]+ steps a hundredth of it had "
          "moved by more than [0-9.]+ m, ever faster\n\n"
          "  where    soil moved furthest from [(][0-9., ]+[)] m, in `clay`: by [0-9.]+ m\n"
          "  likely   it cannot stand under its weight, its water and its loads\n"
          "  try      initial[.]stress = \"k0\", to see it fail; a stronger soil; or at_strength below 1 in a first "
          "stage, as `terp import --held` writes it [(]docs/troubleshooting[.]md#no-equilibrium[)]"));
  Real farthest = 0.0;
  const auto points = points_by_id(s.state);
  for (const Point& p : points)
    farthest =
        std::max(farthest, std::hypot(p.x[0] - s.state.x_initial[2 * p.id], p.x[1] - s.state.x_initial[2 * p.id + 1]));
  EXPECT_GT(farthest, 0.1) << "displacements are those of the soil as it is";
  for (const Point& p : points) EXPECT_LT(p.x[0], 8.01) << "and its places those of the section";
}

TEST(Equilibrium, AFaceThatRavelsHasACureOfItsOwn)
{
  Case c = column("mpm_gp", 0.25);
  c.bodies[0].polygon = {{0.0, 0.0}, {8.0, 0.0}, {6.0, 2.0}, {0.0, 2.0}};
  c.materials[0].model = "mohr_coulomb";
  c.materials[0].parameters = find_material("mohr_coulomb")->complete(std::vector<Real>{2e6, 0.3, 0.0, 30.0});
  c.initial.stress = InitialStress::equilibrium;
  Simulation s(c);
  EXPECT_THAT(
      seek(s), HasSubstr("material.clay.cohesion = { depth = [[0, \"2 kPa\"], [1, \"2 kPa\"], [1, 0], [50, 0]] }"));
}

TEST(Equilibrium, SoilThatSlidesAsDrawnIsToldApartFromASearchThatEndsTooSoon)
{
  Case c = column("mpm_gp", 0.25);
  c.initial.stress = InitialStress::equilibrium;
  Simulation weak(c);
  EXPECT_THAT([&] { weak.start(); }, ThrowsMessage<SlidesAsDrawn>(StartsWith("no equilibrium: the soil fails in ")));
  c.initial.max_steps = 50;
  Simulation brief(c);
  try {
    brief.start();
    FAIL() << "50 steps are too few";
  } catch (const RunError& error) {
    EXPECT_EQ(dynamic_cast<const SlidesAsDrawn*>(&error), nullptr) << "nothing is known of it";
  }
}

TEST(Equilibrium, TooFewStepsAreRefused)
{
  Case c = column("mpm_gp");
  c.initial.stress = InitialStress::equilibrium;
  c.initial.max_steps = 50;
  Simulation s(c);
  const char* expected =
      "no equilibrium: after 50 steps the out-of-balance force is [0-9.e-]+ of the weight, limit 1[.]00e-04\n\n"
      "  where    the largest force is at [(][0-9., ]+[)] m, in `clay`; half of all lies within [0-9.]+ m of it\n"
      "           soil moved furthest from [(][0-9., ]+[)] m, in `clay`: by [0-9.]+ m\n"
      "  likely   the body cannot stand under its own weight, or needs more steps\n"
      "  try      initial[.]stress = \"none\" or \"k0\", a stronger soil, a larger initial[.]max_steps, or at_strength "
      "below 1 in a first stage, as `terp import --held` writes it [(]docs/troubleshooting[.]md#no-equilibrium[)]";
  EXPECT_THAT(seek(s), MatchesRegex(expected));
}

TEST(Equilibrium, ARunThatFindsNoneStopsItselfWithoutAVerdict)
{
  Case c = column("mpm_gp");
  c.initial.stress = InitialStress::equilibrium;
  c.initial.max_steps = 50;
  c.flood.water_level = 1.0;
  Simulation s = followed(c);
  EXPECT_TRUE(summarise(s.model, s.state).flood);
  EXPECT_THAT([&] { s.start(); }, ThrowsMessage<RunError>(StartsWith("no equilibrium: after 50 steps ")));
  EXPECT_FALSE(summarise(s.model, s.state).flood);
}

TEST(Equilibrium, ASearchThatIsStoppedBeginsAnew)
{
  Simulation stopped(confined_box(InitialStress::equilibrium)), whole(confined_box(InitialStress::equilibrium));
  EXPECT_EQ(seek(stopped, true), "");
  EXPECT_EQ(stopped.state.equilibrium_steps, 0);
  ASSERT_EQ(seek(stopped), "");
  ASSERT_EQ(seek(whole), "");
  EXPECT_EQ(first_difference(make_image(stopped.state), make_image(whole.state)), "");
}

struct LastCheckpoint : Observer {
  StateImage image;
  void checkpoint(const std::shared_ptr<const StateImage>& now) override { image = *now; }
};

TEST(Equilibrium, ARunThatIsStoppedInTheSearchGoesOnToTheSameBits)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.time.end = 0.01;
  LastCheckpoint last;
  Simulation whole(c);
  whole.observers = {&last};
  ASSERT_EQ(whole.run(), Outcome::finished);
  const StateImage expected = last.image;
  Simulation first(c);
  first.observers = {&last};
  EXPECT_EQ(first.run(std::atomic<bool>{true}), Outcome::interrupted);
  EXPECT_EQ(last.image.step, 0);
  Simulation second(build_model(c, 1), restore(first.model, last.image));
  second.observers = {&last};
  EXPECT_EQ(second.run(), Outcome::finished);
  EXPECT_EQ(first_difference(last.image, expected), "");
}

TEST(Settle, InMotionSaysHowManyStepsItWillTake)
{
  Simulation s(confined_box(InitialStress::equilibrium));
  std::vector<SearchProgress> told;
  const auto tell = [&](const SearchProgress& p) { told.push_back(p); };
  ASSERT_TRUE(settle_in_motion(s.model, s.state, s.work, 1.0, std::atomic<bool>{false}, tell).reached);
  ASSERT_EQ(std::ssize(told), s.state.equilibrium_steps);
  EXPECT_FALSE(told.front().more_steps);
  EXPECT_LE(told.back().out_of_balance, 1e-4);
  const auto known = std::ranges::find_if(told, [](const SearchProgress& p) { return p.more_steps.has_value(); });
  ASSERT_NE(known, told.end());
  const auto left = static_cast<Real>(s.state.equilibrium_steps - known->steps);
  EXPECT_NEAR(static_cast<Real>(*known->more_steps), left, 0.5 * left + 20.0);
}

TEST(Equilibrium, BodiesAndSidesThatMoveStandStillInIt)
{
  Case c = confined_box(InitialStress::equilibrium), moves = c;
  moves.bodies[0].velocity = {1.0, 0.0};
  moves.sides[1].kind = SideKind::velocity;
  moves.sides[1].slip = true;
  moves.sides[1].velocity = {-0.1, 0.0};
  Simulation s(c), t(moves);
  ASSERT_EQ(seek(s), "");
  ASSERT_EQ(seek(t), "");
  const auto a = points_by_id(s.state), b = points_by_id(t.state);
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].sigma, b[k].sigma);
    EXPECT_EQ(b[k].v, (Vec<2>{0.0, 0.0}));
  }
}

TEST(Settle, SoilThatLeavesEndsIt)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.materials = {elastic(1e5, 0.3, 2000.0)};  // soft: it bulges by more than half the distance between points
  c.sides[1].kind = SideKind::open;
  Simulation s(c);
  EXPECT_EQ(settle_in_motion(s.model, s.state, s.work, 1.0, std::atomic<bool>{false}).fault,
      "in the search for equilibrium soil left through an open side; give that side a `roller`, or start with \"k0\"");
}

TEST(Settle, AValueThatIsNotANumberEndsIt)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.bodies[0].velocity = {NAN, 0.0};
  Simulation s(c);
  EXPECT_THAT(settle_in_motion(s.model, s.state, s.work, 1.0, std::atomic<bool>{false}).fault,
      StartsWith("in the search for equilibrium: step 0, t = 0.0000 s: the "));
}

}  // namespace equilibrium_test
