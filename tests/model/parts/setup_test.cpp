#include "support/paths.hpp"
#include "support/simulations.hpp"

namespace setup_test {

Case box() { return free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0}); }

/// The only problem of a case that is refused; an empty one if it is accepted.
Problem problem_of(const Case& c)
{
  const auto problems = problems_of([&] {
    Model model = build_model(c, 1);
    build_state(model);
  });
  EXPECT_LE(problems.size(), 1u);
  return problems.empty() ? Problem{} : problems[0];
}

TEST(Setup, TheTimeStepIsTheCourantNumberTimesTheSmallestAltitudeOverTheWaveSpeed)
{
  const Model model = build_model(column("mpm_gp", 0.1), 1);
  // K = 49.33 MPa, G = 2 MPa, rho = 1990 kg/m^3: c_p = 161.65 m/s (reading R19).
  const Real stable = 0.98 * 0.1 / std::sqrt((2.0 * 2e6 * 1.48 / (3.0 * 0.04) + 4.0 / 3.0 * 2e6) / 1990.0);
  EXPECT_EQ(model.n_steps, 6598);
  EXPECT_EQ(model.dt, 4.0 / 6598);
  EXPECT_LE(model.dt, stable);
  EXPECT_GT(model.dt, 0.999 * stable);
}

TEST(Setup, AnotherEndOfARunThatGoesOnKeepsItsTimeStep)
{
  Model model = build_model(column("mpm_gp"), 1);
  const Real dt = model.dt;
  move_end(model, 2.5 * model.description.time.end);
  EXPECT_EQ(model.dt, dt);
  EXPECT_EQ(model.n_steps, static_cast<std::int64_t>(std::ceil(2.5 * column("mpm_gp").time.end / dt * (1.0 - 1e-12))));
  EXPECT_EQ(model.description.time.end, static_cast<Real>(model.n_steps) * dt);
  EXPECT_THROW(move_end(model, 1e12), InputError);
}

TEST(Setup, ViscosityShortensTheTimeStep)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0}, {"water", "newtonian_fluid", 1000.0, {1e6, 0.0, 0.0}});
  const Real wave = std::sqrt(1e6 / 1000.0), height = 0.25;
  EXPECT_LE(build_model(c, 1).dt, 0.98 * height / wave);
  c.materials[0].parameters[1] = 5e3;  // Pa s
  const Real z = 4.0 * 5.0 / (3.0 * wave * height), stable = 0.98 * height / wave * (std::sqrt(1.0 + z * z) - z);
  EXPECT_LE(build_model(c, 1).dt, stable);
  EXPECT_GT(build_model(c, 1).dt, 0.9 * stable);
}

// Decision 0042: soil overlaps, water that breaks up would stop itself. What the case says is taken.
TEST(Setup, PointsOverlapUnlessTheCaseSaysOtherwiseOrHasAFluid)
{
  const MaterialCase water{"water", "newtonian_fluid", 1000.0, {1e6, 0.0, 0.0}};
  Case c = box();
  const auto shares = [&c] { return build_model(c, 1).method.shares; };
  EXPECT_EQ(shares(), Shares::overlap);
  c.materials.push_back(water);  // of no body
  EXPECT_EQ(shares(), Shares::overlap);
  c.bodies.push_back(body("water", {2.0, 0.5}, {2.5, 1.0}));
  EXPECT_EQ(shares(), Shares::point);
  c.method.shares = Shares::overlap;
  EXPECT_EQ(shares(), Shares::overlap);
  c.bodies.pop_back();
  c.method.shares = Shares::point;
  EXPECT_EQ(shares(), Shares::point);
}

TEST(Setup, OnlyMaterialsOfBodiesDecideTheTimeStep)
{
  Case c = column("mpm_gp");
  const Real dt = build_model(c, 1).dt;
  c.materials.push_back(elastic(1e12, 0.3, 3000.0));
  const Model model = build_model(c, 1);
  EXPECT_EQ(model.dt, dt);
  EXPECT_EQ(model.largest_density, 1990.0);
  EXPECT_EQ(model.rows.added().size(), 1u);
}

TEST(Setup, AVelocityThatDependsOnThePlaceIsThatOfEachPoint)
{
  Case c = box();
  c.bodies[0].velocity = {7.0, 7.0};
  c.bodies[0].velocity_at = [](Vec<2> x) { return Vec<2>{2.0 * x[1], -x[0] * x[1]}; };
  Model model = build_model(c, 1);
  const State state = build_state(model);
  for (const Point& p : points_by_id(state)) EXPECT_EQ(p.v, (Vec<2>{2.0 * p.x[1], -p.x[0] * p.x[1]}));
}

TEST(Setup, AVelocityThatIsNoNumberSomewhereIsRefused)
{
  const auto none_below = [](Vec<2> x) { return Vec<2>{std::sqrt(x[1] - 0.7), 0.0}; };
  Case c = box();
  c.bodies[0].velocity_at = none_below;
  EXPECT_THAT(problem_of(c), told("body[0].velocity", "the velocity is not a finite number everywhere in the body"));
  c.bodies[0].velocity_at = {};
  c.sides = {side("left", SideKind::velocity)};
  c.sides[0].velocity_at = none_below;
  EXPECT_THAT(
      problem_of(c), told("boundary.\"left\".velocity", "the velocity is not a finite number everywhere on the side"));
}

TEST(Setup, SeedsBodiesWithTheirVelocityMassAndLocalPlaces)
{
  Case c = box();
  c.bodies[0].points_per_cell = {2, 3};
  c.bodies[0].velocity = {1.5, -0.5};
  Model model = build_model(c, 1);
  const State state = build_state(model);
  const auto points = points_by_id(state);
  ASSERT_EQ(points.size(), 4u * 6u);
  for (const Point& p : points) {
    EXPECT_NEAR(p.volume, 0.0625 / 6.0, 1e-15);
    EXPECT_NEAR(p.mass, 1990.0 * 0.0625 / 6.0, 1e-12);
    EXPECT_EQ(p.v, (Vec<2>{1.5, -0.5}));
    EXPECT_EQ(state.x_initial[2 * p.id], p.x[0]);
    EXPECT_EQ(state.x_initial[2 * p.id + 1], p.x[1]);
    EXPECT_NEAR(std::abs(p.local[0]), 0.5, 1e-12);
    EXPECT_EQ(p.sigma, (std::array<Real, 4>{}));
  }
}

TEST(Setup, FollowsTheNearestPointAndOfEqualOnesThatWithLowerXThenLowerY)
{
  Case c = box();  // points at 1.025, 1.075, ...
  c.output.history_points = {{"A", {1.13, 0.68}}, {"B", {1.1, 0.6}}, {"C", {9.0, 9.0}}};
  Model model = build_model(c, 1);
  const State state = build_state(model);
  ASSERT_EQ(model.history_ids.size(), 3u);
  const auto place = [&](int k) {
    return Vec<2>{state.x_initial[2 * model.history_ids[k]], state.x_initial[2 * model.history_ids[k] + 1]};
  };
  const auto expect_place = [&](int k, Real x, Real y) {
    EXPECT_NEAR(place(k)[0], x, 1e-12);
    EXPECT_NEAR(place(k)[1], y, 1e-12);
  };
  expect_place(0, 1.125, 0.675);
  expect_place(1, 1.075, 0.575);  // four points are 35 mm away
  expect_place(2, 1.475, 0.975);
}

TEST(Setup, LaterBodiesLieOnTopOfEarlierOnes)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.bodies.push_back(body("rock", {1.5, 0.5}, {2.0, 1.0}));
  Model model = build_model(c, 1);
  const State state = build_state(model);
  EXPECT_EQ(state.points.n_points(), 8 * 25);
  for (const Point& p : points_by_id(state)) EXPECT_EQ(p.material, p.x[0] > 1.5 ? 1 : 0);
}

TEST(Setup, SaysWhatIsWrongWithACase)
{
  const auto with_side = [&](SideKind kind) {
    Case c = box();
    c.sides = {side("wall", kind)};
    return c;
  };
  Case fine = box(), empty = box(), no_law = column("mpm_gp"), no_soil = no_law;
  fine.mesh.cell = {1e-5, 0.25};
  empty.bodies[0].holes = {empty.bodies[0].polygon};
  no_law.materials[0].model = "mohr";
  no_soil.bodies[0].material = "sand";
  const auto no_wall =
      told("boundary.wall", "the mesh has no side `wall`", "Sides of this mesh: left, right, bottom, top");
  const std::pair<Case, testing::Matcher<const Problem&>> rows[] = {
      {free_box("mpm_gp", {1.0, 0.5}, {4.5, 1.0}), told("body[0]", "the body lies outside the mesh",
                                                       "corner (4.5, 0.5) m lies in no cell; the mesh spans x = 0 to 4 "
                                                       "m, y = 0 to 2 m.\nEnlarge the mesh or move the body.")},
      {fine, told("mesh.cell", "the mesh has too many cells", "4e+05 cells in one direction, at most 100000.")},
      {empty, told("body[0]", "no material points",
                  "The bodies hold no point of the seeding lattice. Use a larger body, smaller cells or more points "
                  "per cell.")},
      {with_side(SideKind::free), no_wall},
      {with_side(SideKind::open), no_wall},
      {with_side(SideKind::roller), no_wall},
      {free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0},
           elastic(1e23, 0.25, 1000.0)),  // c_p = sqrt(3 G / rho) = 1.732e10 m/s at nu = 0.25
          told("time.end", "the time step has collapsed",
              "1 s need 7.07e+10 steps of 1.41e-11 s (smallest cell altitude 0.25 m, wave speed 1.732e+10 m/s).")},
      {column("mpm_gpp"), told("scheme", "no such scheme")},
      {no_law, told("material.clay.model", "no such material model")},
      {no_soil, told(_, "no material `sand`")},
  };
  for (const auto& [c, problem] : rows) EXPECT_THAT(problem_of(c), problem);
  EXPECT_THAT(problems_of([] { build_model(column("mpm_gp"), 0); }),
      ElementsAre(told("threads", "a run needs at least one thread", "Got 0.")));
}

TEST(Setup, MoreThanTwentyMillionCellsAreRefusedAtOnceWhateverTheKindOfMesh)
{
  Case c = box();  // 4 m x 2 m
  const auto refused = [&](const std::string& key, const std::string& number) {
    EXPECT_THAT(problem_of(c), told(key, "the mesh has too many cells",
                                   StartsWith("About " + number + " million cells, at most 20 million.")));
  };
  c.mesh.cell = {5e-4, 5e-4};
  refused("mesh.cell", "32");
  c.mesh.kind = MeshKind::graded;
  c.mesh.cells = {30000, 1000};
  refused("mesh.cells", "30");
  c.mesh.kind = MeshKind::polygon;
  c.mesh.polygon = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}};
  c.mesh.cell = {1e-4, 1e-4};
  refused("mesh.cell", "400");
  c.mesh.cell = {0.1, 0.1};
  c.mesh.refine = {{{}, {0.0, 0.0}, {1.0, 0.5}, 1e-4, 0.0}};
  refused("mesh.refine[0].cell", "50");
}

TEST(Setup, ACornerThatAMappedGridCutsOffIsRefusedWithTheReason)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 2.0});
  c.mesh.kind = MeshKind::mapped;
  c.mesh.sides = {{{{0, 0}, {2, -1}, {4, 0}}, {{4, 0}, {4, 2}}, {{0, 2}, {4, 2}}, {{0, 0}, {0, 2}}}};
  c.mesh.cells = {5, 4};
  c.bodies[0].polygon = {{0.0, 0.0}, {2.0, -1.0}, {4.0, 0.0}, {4.0, 2.0}, {0.0, 2.0}};
  EXPECT_THAT(
      problem_of(c).detail, AllOf(StartsWith("corner (2, -1) m lies in no cell;"),
                                HasSubstr("follows mesh.sides only at its nodes"), HasSubstr("Use more cells")));
  c.mesh.cells = {6, 4};
  EXPECT_EQ(problem_of(c).what, "");
}

TEST(Setup, AnUnknownMaterialInAFileOfPointsIsToldWithItsLine)
{
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/points.csv") << "x,y,volume,material\n1.1,0.6,0.01,clay\n1.2,0.6,0.01,clayy\n";
  Case c = box();
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.folder = folder.path();
  c.bodies[0].polygon.clear();
  c.bodies[0].points_file = "points.csv";
  const Problem p = problem_of(c);
  EXPECT_THAT(p, told("body[0].points", _,
                     folder.path() + "/points.csv:3: no material `clayy`. Materials of this case: clay, rock"));
}

}  // namespace setup_test
