// The stress with which a run starts.
#include "simulation/initial.hpp"
#include "base/errors.hpp"
#include "simulation/run.hpp"
#include "simulation/setup.hpp"
#include "simulation/state_image.hpp"
#include "support/cases.hpp"
#include "support/simulations.hpp"
#include "support/test.hpp"

namespace {

constexpr Real g = 9.81;

/// The search for equilibrium; what went wrong, or nothing.
std::string seek(Simulation& s, bool stopped = false)
{
  const std::atomic<bool> stop{stopped};
  return seek_equilibrium(s.model, s.state, s.work, stop).fault;
}

/// An elastic box between rollers.
Case confined_box(InitialStress stress)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.5}, elastic(2e6, 0.3, 2000.0));
  c.forces.gravity = {0.0, -g};
  c.forces.local_damping = 0.1;
  c.initial.stress = stress;
  for (const char* name : {"left", "right", "bottom"}) c.sides.push_back(side(name, SideKind::roller));
  return c;
}

TEST(InitialStress, NoneStartsWithoutStress)
{
  for (const Point& p : points_by_id(Simulation(confined_box(InitialStress::none)).state))
    EXPECT_EQ(p.sigma, (std::array<Real, 4>{}));
}

TEST(InitialStress, K0CarriesTheWeightOfTheSoilAbove)
{
  Case c = confined_box(InitialStress::k0);
  c.initial.k0 = 0.7;
  for (const Point& p : points_by_id(Simulation(c).state)) {
    const Real vertical = -2000.0 * g * (1.5 - p.x[1]);
    EXPECT_NEAR(p.sigma[1], vertical, 1e-9);
    EXPECT_NEAR(p.sigma[0], 0.7 * vertical, 1e-9);
    EXPECT_NEAR(p.sigma[2], 0.7 * vertical, 1e-9);
    EXPECT_EQ(p.sigma[3], 0.0);
  }
}

TEST(InitialStress, K0IsOfTheEffectiveStressAndOfEachMaterial)
{
  for (const Drainage drainage : {Drainage::drained, Drainage::undrained}) {
    Case c = confined_box(InitialStress::k0);
    c.initial.k0 = 0.7;
    c.materials[0].k0 = 0.4;
    c.materials[0].drainage = drainage;
    c.water.unit_weight = 10e3;
    c.water.start.phreatic_line = {{0.0, 1.75}};
    for (const Point& p : points_by_id(Simulation(c).state)) {
      const Real pore = 10e3 * (1.75 - p.x[1]), effective = -2000.0 * g * (1.5 - p.x[1]) - 10e3 * 0.25 + pore;
      const Real stored = drainage == Drainage::undrained ? pore : 0.0;
      EXPECT_NEAR(p.sigma[1], effective - stored, 1e-8);
      EXPECT_NEAR(p.sigma[0], 0.4 * effective - stored, 1e-8);
      EXPECT_NEAR(p.sigma[2], 0.4 * effective - stored, 1e-8);
    }
  }
}

TEST(InitialStress, K0CountsEachLayerWithItsOwnDensityAndAnOverlapOnce)
{
  Case c = confined_box(InitialStress::k0);
  c.materials.push_back(clay());                              // 1990 kg/m^3
  c.bodies.push_back(body("clay", {0.0, 1.0}, {2.0, 1.75}));  // lies on top of the left half, and on part of it
  for (const Point& p : points_by_id(Simulation(c).state)) {
    const bool left = p.x[0] < 2.0;
    const Real top = left ? 1.75 : 1.5, border = left ? 1.0 : 1.5;
    const Real clay = left ? 1990.0 * (top - std::max(p.x[1], border)) : 0.0;
    const Real rock = 2000.0 * std::max(0.0, border - p.x[1]);
    EXPECT_NEAR(p.sigma[1], -g * (clay + rock), 1e-9);
  }
}

/// The confined box, its bodies regions of a mesh: `cells` of the 16 x 8 mesh are the region "rock".
Simulation box_of_region(const std::vector<Index>& cells, const std::vector<BodyCase>& more = {})
{
  Case c = confined_box(InitialStress::k0);
  c.bodies[0].polygon.clear();
  c.bodies[0].region = "rock";
  c.materials.push_back(clay());
  c.bodies.insert(c.bodies.end(), more.begin(), more.end());
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 2.0}, {16, 8});
  mesh.regions = {{"rock", cells}};
  Model model = build_model(c, std::make_shared<const Mesh<2>>(std::move(mesh)), 1);
  State state = build_state(model);
  return Simulation(std::move(model), std::move(state));
}

std::vector<Index> lowest_rows(Index n)
{
  std::vector<Index> cells(16 * static_cast<std::size_t>(n));
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
}

TEST(InitialStress, K0TakesARegionForTheUnionOfItsCells)
{
  const auto of_box = points_by_id(Simulation(confined_box(InitialStress::k0)).state);
  const auto of_region = points_by_id(box_of_region(lowest_rows(6)).state);
  ASSERT_EQ(of_region.size(), of_box.size());
  for (std::size_t k = 0; k < of_box.size(); ++k)
    for (int d = 0; d < 4; ++d) EXPECT_NEAR(of_region[k].sigma[d], of_box[k].sigma[d], 1e-9);
}

TEST(InitialStress, K0OfARegionCarriesTheBodyOnItAndSkipsTheHoleInIt)
{
  std::vector<Index> cells = lowest_rows(6);
  cells.erase(cells.begin() + 16 * 2 + 8);  // x = 2 to 2.25 m, y = 0.5 to 0.75 m
  const Simulation s = box_of_region(cells, {body("clay", {0.0, 1.25}, {3.0, 1.75})});  // one row deep in the rock
  for (const Point& p : points_by_id(s.state)) {
    const Real x = p.x[0], y = p.x[1], top = x < 3.0 ? 1.75 : 1.5, border = x < 3.0 ? 1.25 : 1.5;
    const Real hole = x > 2.0 && x < 2.25 && y < 0.5 ? 0.25 : 0.0;
    const Real weight =
        1990.0 * (top - std::max(y, border)) * (x < 3.0 ? 1.0 : 0.0) + 2000.0 * (std::max(0.0, border - y) - hole);
    EXPECT_NEAR(p.sigma[1], -g * weight, 1e-8) << x << ' ' << y;
  }
}

TEST(InitialStress, K0SkipsTheGapUnderAnOverhang)
{
  Case c = confined_box(InitialStress::k0);
  c.bodies[0].polygon = {
      {0.0, 0.0}, {4.0, 0.0}, {4.0, 1.5}, {1.0, 1.5}, {1.0, 1.0}, {3.0, 1.0}, {3.0, 0.5}, {0.0, 0.5}};
  for (const Point& p : points_by_id(Simulation(c).state)) {
    if (p.x[0] < 1.0 || p.x[0] > 3.0 || p.x[1] > 0.5) continue;
    EXPECT_NEAR(p.sigma[1], -2000.0 * g * (0.5 - p.x[1] + 0.5), 1e-9);
  }
}

TEST(Equilibrium, AnElasticBoxComesToRestUnderItsWeight)
{
  Simulation s(confined_box(InitialStress::equilibrium));
  ASSERT_EQ(seek(s), "");
  EXPECT_LE(s.work.unbalanced_ratio, 1e-3);
  std::vector<Vec<2>> mean(s.model.mesh->cells.size(), {0.0, 0.0});  // stress xx, yy of each cell [Pa]
  for (const Point& p : points_by_id(s.state))
    for (int k = 0; k < 2; ++k) mean[p.cell][k] += p.sigma[k] / 25.0;
  for (Index cell = 0; cell < 6 * 16; ++cell) {
    const Real vertical = -2000.0 * g * (1.5 - s.model.mesh->centres[cell][1]);
    EXPECT_NEAR(mean[cell][1], vertical, 0.02 * 2000.0 * g * 1.5);
    EXPECT_NEAR(mean[cell][0], 0.3 / 0.7 * vertical, 0.02 * 2000.0 * g * 1.5);  // nu / (1 - nu), confined
  }
}

TEST(Equilibrium, MotionAndHistoryStartAnewWhenItIsReached)
{
  Simulation s(confined_box(InitialStress::equilibrium));
  ASSERT_EQ(seek(s), "");
  for (const Point& p : points_by_id(s.state)) {
    EXPECT_EQ(p.v, (Vec<2>{0.0, 0.0}));
    EXPECT_EQ(p.strain, (std::array<Real, 4>{}));
    for (int d = 0; d < 2; ++d) EXPECT_EQ(s.state.x_initial[2 * p.id + d], p.x[d]);
  }
  EXPECT_EQ(s.state.step, 0);
  EXPECT_EQ(s.state.time, 0.0);
  EXPECT_EQ(s.state.work.gravity, 0.0);
  EXPECT_EQ(s.work.damping_local, 0.1);  // no longer that of the search
}

TEST(Equilibrium, PlasticStrainIsResetToo)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.materials = {clay({.poisson_ratio = 0.3, .su_peak = 5e3, .su_residual = 5e3})};
  c.bodies[0].material = "clay";
  Simulation s = followed(c);
  s.start();  // seeks, then audits
  for (const Point& p : points_by_id(s.state)) EXPECT_EQ(p.eps_eq_p(), 0.0);
  for (const Real eps : array_of(s.state, "followers/history_audit/last_eps_eq_p")) EXPECT_EQ(eps, 0.0);
}

TEST(Equilibrium, AColumnThatCannotStandIsRefused)
{
  Case c = column("mpm_gp");
  c.initial.stress = InitialStress::equilibrium;
  c.initial.max_steps = 500;
  Simulation s(c);
  const char* expected =
      "no equilibrium: after 500 steps the out-of-balance force is [0-9.e-]+ of the weight, limit 1[.]00e-03\n\n"
      "  where    the largest force is at [(][0-9., ]+[)] m, in `clay`; half of all lies within [0-9.]+ m of it\n"
      "           soil moved furthest from [(][0-9., ]+[)] m, in `clay`: by [0-9.]+ m\n"
      "  likely   the body cannot stand under its own weight, or needs more steps\n"
      "  try      initial[.]stress = \"none\" or \"k0\", a stronger soil, or a larger initial[.]max_steps "
      "[(]docs/troubleshooting[.]md#no-equilibrium[)]";
  EXPECT_THAT(seek(s), MatchesRegex(expected));
}

TEST(Equilibrium, AColumnThatFlowsUntilItRestsIsRefused)
{
  Case c = column("mpm_gp", 0.25);
  c.initial.stress = InitialStress::equilibrium;
  Simulation s(c);
  EXPECT_THAT(seek(s), MatchesRegex("no equilibrium: the body came to rest only after [0-9]+ % of its soil "
                                    "had yielded and moved by up to [1-9][.][0-9]+ m\n\n"
                                    "  where    soil moved furthest from [(][0-9., ]+[)] m, in `clay`: by [0-9.]+ m\n"
                                    "  likely   the body cannot stand under its own weight\n.*"));
}

TEST(Equilibrium, ARunThatFindsNoneStopsItself)
{
  Case c = column("mpm_gp");
  c.initial.stress = InitialStress::equilibrium;
  c.initial.max_steps = 50;
  Simulation s(c);
  EXPECT_THAT([&] { s.start(); }, ThrowsMessage<RunError>(StartsWith("no equilibrium: after 50 steps ")));
}

TEST(Equilibrium, ASearchThatIsStoppedGoesOnWhereItWas)
{
  Simulation stopped(confined_box(InitialStress::equilibrium)), whole(confined_box(InitialStress::equilibrium));
  EXPECT_EQ(seek(stopped, true), "");
  EXPECT_EQ(stopped.state.equilibrium_steps, 0);
  stopped.model.description.initial.max_steps = 50;
  EXPECT_NE(seek(stopped), "");  // not yet
  stopped.model.description.initial.max_steps = whole.model.description.initial.max_steps;
  ASSERT_EQ(seek(stopped), "");
  ASSERT_EQ(seek(whole), "");
  EXPECT_GT(whole.state.equilibrium_steps, 50);
  EXPECT_EQ(first_difference(make_image(stopped.state), make_image(whole.state)), "");
}

/// Asks for a stop once the search has made so many steps.
class StopsAfter {
 public:
  StopsAfter(Simulation& s, std::int64_t n_steps) : model_(s.model), step_(s.model.step), n_steps_(n_steps)
  {
    current = this;
    s.model.step = [](const Model& model, State& state, Workspace& work) {
      current->step_(model, state, work);
      if (state.equilibrium_steps + 1 == current->n_steps_) current->stop = true;
    };
  }
  ~StopsAfter() { model_.step = step_; }
  std::atomic<bool> stop{false};

 private:
  static inline StopsAfter* current = nullptr;
  Model& model_;
  decltype(Model::step) step_;
  std::int64_t n_steps_;
};

struct LastCheckpoint : Observer {
  StateImage image;
  void checkpoint(const std::shared_ptr<const StateImage>& now) override { image = *now; }
};

TEST(Equilibrium, ARunThatIsStoppedAnywhereAboutTheEndOfTheSearchGoesOnToTheSameBits)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.time.end = 0.01;
  LastCheckpoint last;
  Simulation whole(c);
  whole.observers = {&last};
  ASSERT_EQ(whole.run(), Outcome::finished);
  const StateImage expected = last.image;
  const std::int64_t n = whole.state.equilibrium_steps;
  for (const std::int64_t after : {n - 1, n}) {
    Simulation first(c);
    StopsAfter stops(first, after);
    first.observers = {&last};
    EXPECT_EQ(first.run(stops.stop), Outcome::interrupted) << after;
    EXPECT_EQ(last.image.step, after < n ? 0 : 1);
    Simulation second(build_model(c, 1), restore(first.model, last.image));
    second.observers = {&last};
    EXPECT_EQ(second.run(), Outcome::finished);
    EXPECT_EQ(first_difference(last.image, expected), "") << after;
  }
}

TEST(Equilibrium, SoilThatLeavesEndsTheSearch)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.materials = {elastic(1e5, 0.3, 2000.0)};  // soft: it bulges by more than half the distance between points
  c.sides[1].kind = SideKind::open;
  Simulation s(c);
  EXPECT_EQ(seek(s),
      "in the search for equilibrium soil left through an open side; give that side a `roller`, or start with \"k0\"");
}

TEST(Equilibrium, AValueThatIsNotANumberEndsTheSearch)
{
  Case c = confined_box(InitialStress::equilibrium);
  c.bodies[0].velocity = {NAN, 0.0};
  Simulation s(c);
  EXPECT_THAT(seek(s), StartsWith("in the search for equilibrium: step 0, t = 0.0000 s: the "));
}

}  // namespace
