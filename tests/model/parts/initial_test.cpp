#include "model/parts/initial.hpp"
#include "support/simulations.hpp"
#include "support/stages.hpp"

namespace initial_test {

constexpr Real g = 9.81;

TEST(InitialStress, NoneStartsWithoutStress)
{
  for (const Point& p : points_by_id(Simulation(confined_box(InitialStress::none)).state))
    EXPECT_EQ(p.sigma, (std::array<Real, 4>{}));
}

TEST(InitialStress, IsThatOfTheBodyWhereItGivesOne)
{
  Case c = confined_box(InitialStress::none);
  const std::string material = c.bodies[0].material;
  c.bodies = {body(material, {0.0, 0.0}, {2.0, 1.5}), body(material, {2.0, 0.0}, {4.0, 1.5})};
  c.bodies[1].stress = {-5e3, -10e3, -4e3, 250.0};
  for (const Point& p : points_by_id(Simulation(c).state))
    EXPECT_EQ(p.sigma, (p.x[0] > 2.0 ? *c.bodies[1].stress : std::array<Real, 4>{}));
  c.bodies[1].placed = 1;
  EXPECT_THAT(
      refusal<InputError>([&] { Simulation s(c); }), HasSubstr("a body that a stage places has no stress at t = 0"));
}

TEST(InitialStress, OfABodyMustBeOneThatItsLawAdmits)
{
  Case c = confined_box(InitialStress::none);
  c.materials[0] = {c.materials[0].name, "modified_cam_clay", 2000.0, {25.0, 0.3, 0.05, 1.8, 0.2, 20e3, 100e3, 1e3}};
  c.bodies[0].stress = {-10e3, -10e3, -10e3, 0.0};
  Simulation admitted(c);
  c.bodies[0].stress = {-60e3, -60e3, -60e3, 0.0};
  EXPECT_THAT(refusal<InputError>([&] { Simulation s(c); }), HasSubstr("yield_stress"));
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

TEST(InitialStress, TheSearchForEquilibriumBeginsWithTheK0ThatAMaterialGivesAlsoWithoutWater)
{
  Case c = confined_box(InitialStress::equilibrium);
  for (const Point& p : points_by_id(Simulation(c).state)) EXPECT_EQ(p.sigma[1], 0.0);
  c.materials[0].k0 = 0.4;
  for (const Point& p : points_by_id(Simulation(c).state)) {
    EXPECT_NEAR(p.sigma[1], -2000.0 * g * (1.5 - p.x[1]), 1e-8);
    EXPECT_NEAR(p.sigma[0], 0.4 * p.sigma[1], 1e-8);
  }
}

TEST(InitialStress, K0OfSoilWithFrictionAngleAndYieldStressFollowsItsOverconsolidation)
{
  Case c = confined_box(InitialStress::k0);
  MaterialCase clay{"clay", "modified_cam_clay", 2000.0, {30.0, 0.3, 0.05, 1.8, 0.2, 40e3, 100e3, 1e3}};
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_NEAR(k0_at(c, clay, {}, 40e3), 0.5, 1e-12);                   // 1 - sin(30)
  EXPECT_NEAR(k0_at(c, clay, {}, 10e3), 0.5 * std::sqrt(4.0), 1e-12);  // OCR of 4
  EXPECT_NEAR(k0_at(c, clay, {}, 80e3), 0.5, 1e-12);                   // it yields: as normally consolidated
  EXPECT_NEAR(k0_at(c, clay, {}, 0.0), 3.0, 1e-12);                    // passive: (1 + sin)/(1 - sin)
  c.initial.k0 = 0.7;
  EXPECT_EQ(k0_at(c, clay, {}, 10e3), 0.7);
  clay.k0 = 0.6;
  EXPECT_EQ(k0_at(c, clay, {}, 10e3), 0.6);
  c.initial.k0 = nan;
  EXPECT_EQ(k0_at(c, c.materials[0], {}, 10e3), 1.0);
}

TEST(InitialStress, K0CountsEachLayerWithItsOwnDensityAndAnOverlapOnce)
{
  Case c = confined_box(InitialStress::k0);
  c.initial.k0 = 0.7;
  c.materials.push_back(clay());                              // 1990 kg/m^3
  c.bodies.push_back(body("clay", {0.0, 1.0}, {2.0, 1.75}));  // lies on top of the left half, and on part of it
  for (const Point& p : points_by_id(Simulation(c).state)) {
    const bool left = p.x[0] < 2.0;
    const Real top = left ? 1.75 : 1.5, border = left ? 1.0 : 1.5;
    const Real clay = left ? 1990.0 * (top - std::max(p.x[1], border)) : 0.0;
    const Real rock = 2000.0 * std::max(0.0, border - p.x[1]);
    EXPECT_NEAR(p.sigma[1], -g * (clay + rock), 1e-9);
    for (const int k : {0, 2}) EXPECT_NEAR(p.sigma[k], -0.7 * g * (clay + rock), 1e-9);
    EXPECT_EQ(p.sigma[3], 0.0);
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

/// The confined box of Modified Cam-Clay, without water [Pa].
Case box_of_cam_clay(InitialStress stress, Real yield_stress, Real largest = 100e3)
{
  Case c = confined_box(stress);
  c.materials = {{"clay", "modified_cam_clay", 1600.0, {30.0, 0.3, 0.05, 1.8, 0.2, yield_stress, largest, 1e3}}};
  c.bodies[0].material = "clay";
  c.initial.k0 = 0.5;
  return c;
}

TEST(InitialStress, K0OutsideAYieldSurfaceIsRefusedWithItsPlace)
{
  EXPECT_EQ(refusal([] { Simulation(box_of_cam_clay(InitialStress::k0, 25e3)); }), "");
  EXPECT_THAT(refusal([] { Simulation(box_of_cam_clay(InitialStress::k0, 15e3)); }),
      AllOf(HasSubstr("the starting stress lies outside the yield surface"), HasSubstr("At the point at ("),
          HasSubstr("times the yield_stress")));
  EXPECT_THAT(refusal([] { Simulation(box_of_cam_clay(InitialStress::k0, 25e3, 10e3)); }),
      HasSubstr("the soil starts with more than its largest mean stress"));
}

TEST(InitialStress, SoilThatYieldsInTheSearchForEquilibriumStartsWithTheYieldSurfaceOfItsStress)
{
  for (const Real yield_stress : {15e3, 60e3}) {
    Simulation s(box_of_cam_clay(InitialStress::equilibrium, yield_stress));
    const Real first = s.model.materials[0].law->derived(0, s.model.materials[0].view(s.state.points.block(0), 0));
    ASSERT_EQ(s.start(), Outcome::finished);
    Index n_grown = 0;
    for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
      const SoilMaterial& clay = s.model.materials[block.material];
      EXPECT_TRUE(clay.law->check_start(clay.view(block, lane), stress_at(block, lane)).empty());
      n_grown += clay.law->derived(0, clay.view(block, lane)) > first * (1.0 + 1e-6);
      EXPECT_GE(clay.law->derived(0, clay.view(block, lane)), first * (1.0 - 1e-12));
    });
    EXPECT_EQ(n_grown > 0, yield_stress < 25e3);
  }
}

TEST(InitialStress, ASearchThatFindsMoreThanTheLargestMeanStressStopsTheRun)
{
  EXPECT_THAT(refusal([] { Simulation(box_of_cam_clay(InitialStress::equilibrium, 60e3, 10e3)).start(); }),
      AllOf(HasSubstr("material.clay.largest_mean_stress: the soil starts with more than its largest mean stress"),
          HasSubstr("At the point at (")));
}

TEST(InitialStress, SoilThatCarriesMoreThanItsLargestMeanStressIsFound)
{
  Simulation s(box_of_cam_clay(InitialStress::k0, 25e3));
  EXPECT_EQ(describe_overload(s.model, s.state), "");
  for (int k = 0; k < 3; ++k) set_value(s.state, 7, Rows::sigma + k, -120e3);
  EXPECT_THAT(describe_overload(s.model, s.state),
      AllOf(StartsWith("at t = 0 s soil carries more than `material.clay.largest_mean_stress`"),
          HasSubstr("p' = 1.2e+05 Pa, largest_mean_stress = 1e+05 Pa.")));
}

TEST(InitialStress, AStageGivesNoLawThatDoesNotAdmitTheStress)
{
  const auto changed = [](Real yield_stress) {
    Case c = confined_box(InitialStress::k0);
    c.materials.push_back(box_of_cam_clay(InitialStress::k0, yield_stress).materials[0]);
    c.initial.k0 = 0.5;
    Simulation s(
        staged(c, {{stage("a", 0.05), {}}, {stage("b", 0.05), [](Case& now) { now.bodies[0].material = "clay"; }}}));
    return refusal([&] { s.run(); });
  };
  EXPECT_EQ(changed(60e3), "");
  EXPECT_THAT(
      changed(10e3), AllOf(HasSubstr("s: material.clay.yield_stress: the starting stress lies outside the yield "
                                     "surface"),
                         HasSubstr("At the point at (")));
}

}  // namespace initial_test
