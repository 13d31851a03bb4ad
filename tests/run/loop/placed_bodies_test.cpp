// The weight of a body on the ground, and its balance: ledger, `placed_body`.
#include "mpm/features/bodies.hpp"
#include "mpm/features/loads.hpp"
#include "mpm/step/workspace.hpp"
#include "run/loop/placed_bodies.hpp"

#include "run/report/frame.hpp"
#include "model/water/nodal_water.hpp"
#include "run/loop/other_run.hpp"
#include "model/soils/overburden.hpp"
#include "run/loop/stages.hpp"
#include "support/simulations.hpp"
#include "support/stages.hpp"

namespace placed_bodies_test {

constexpr Real g = 10.0, of_ground = 2000.0, of_fill = 1500.0;  // [m/s^2], [kg/m^3]

/// The same case before, while and after a body that stage 1 places and stage 2 digs away is there.
Case with_fill(Case c, const BodyCase& fill, Real ramp)
{
  c.bodies.push_back(fill);
  c.bodies.back().placed = 2, c.bodies.back().removed = 3, c.bodies.back().is_there = false;
  StageCase place = resting("place", 8.0), dig = resting("dig", 8.0);
  place.ramp = dig.ramp = ramp;
  return staged(c, {{resting("settle", 8.0), {}}, {place, [](Case& now) { now.bodies.back().is_there = true; }},
                       {dig, [](Case& now) { now.bodies.back().is_there = false; }}});
}

/// Elastic ground of 1 m between smooth walls, and 0.5 m of fill on a part of it.
Case ground_and_fill(Real from, Real to, Real ramp = 0.5)
{
  Case c = settling();
  c.time.rest_time = 0.2;
  c.materials.push_back(elastic(1e6, 0.3, of_fill));
  c.materials[0].name = "ground", c.materials[1].name = "fill";
  c.bodies[0].material = "ground";
  return with_fill(c, body("fill", {from, 1.0}, {to, 1.5}), ramp);
}

void run_stages(Simulation& s, std::size_t n)
{
  while (s.state.stages_done.size() < n) s.step(1);
}

// Water that stands 0.25 m over the ground, inside the fill; an aquifer that would lift the ground.
TEST(PlacedBodies, HoldDownTheWaterByTheWeightThatTheyHaveSoFar)
{
  constexpr Real ramp = 1.0, of_water = 10e3;  // [s], [N/m^3]
  Case c = settling();
  c.materials.push_back(elastic(1e6, 0.3, of_fill));
  c.materials[0].name = "ground", c.materials[1].name = "fill";
  c.bodies[0].material = "ground";
  c.water.unit_weight = of_water;
  c.water.start.phreatic_line = {{0.0, 1.25}};
  c.water.start.head_lines = {{"aquifer", {{0.0, 30.0}}}};
  c.water.start.reference_lines = {{{{0.0, 0.6}}, "aquifer", "aquifer"}};
  Simulation s(with_fill(c, body("fill", {0.0, 1.0}, {4.0, 1.5}), ramp));
  const auto limit = [&](Real after) {  // of the present stage, at 0.5 m below the ground
    const PorePressure pore = water_at(s.model, s.model.ramp.start + after);
    for (Index i = 0; i < s.model.mesh->n_nodes(); ++i)
      if (const Vec<2> x = s.model.mesh->nodes[i]; std::hypot(x[0] - 2.0, x[1] - 0.5) < 1e-9) return pore.pressure[i];
    return std::nan("");
  };
  const Real without = of_ground * g * 0.5 + of_water * 0.25, with = of_ground * g * 0.5 + of_fill * g * 0.5;
  EXPECT_NEAR(limit(0.0), without, 1e-9);
  run_stages(s, 1);
  s.step(1);
  EXPECT_NEAR(limit(0.0), without, 1e-9);
  EXPECT_NEAR(limit(0.25 * ramp), 0.75 * without + 0.25 * with, 1e-9);
  EXPECT_NEAR(limit(ramp), with, 1e-9);
  run_stages(s, 2);
  s.step(1);
  EXPECT_NEAR(limit(0.0), with, 1e-9);
  EXPECT_NEAR(limit(0.25 * ramp), 0.75 * with + 0.25 * without, 1e-9);
  EXPECT_NEAR(limit(ramp), without, 1e-9);
}

// Without the force that holds its weight the body would begin to fall with g.
TEST(PlacedBodies, ChangeNothingAtFirstAndLetTheirWeightGoOverTheRamp)
{
  Simulation s(ground_and_fill(1.0, 3.0, 1.0));
  run_stages(s, 1);
  s.step(20);
  Real fastest = 0.0;
  for (const Point& p : points_by_id(s.state))
    if (p.material == 1) fastest = std::max(fastest, std::hypot(p.v[0], p.v[1]));
  const Real t = 20.0 * s.model.dt;
  EXPECT_GT(fastest, 0.0);
  EXPECT_LT(fastest, 1.5 * 0.5 * g * t * t / 1.0) << "v = g t^2 / (2 ramp)";
  EXPECT_NEAR(s.work.with.bodies->held.placed, 1.0 - (t - 0.5 * s.model.dt) / 1.0, 1e-9);
  run_stages(s, 2);
  EXPECT_EQ(s.work.with.bodies->held.placed, 0.0);
  EXPECT_FALSE(s.work.outer[outer_load].acts);
}

TEST(PlacedBodies, UnderWaterComeAtRestWhetherTheySoreTotalOrEffectiveStress)
{
  for (const Drainage drainage : {Drainage::drained, Drainage::undrained}) {
    Case c = settling();
    c.time.rest_time = 0.2;
    c.water.start.phreatic_line = {{0.0, 1.9}};
    c.materials[0].name = "ground";
    c.materials[0].drainage = Drainage::drained;
    c.materials.push_back(elastic(1e6, 0.3, of_fill));
    c.materials[1].name = "fill";
    c.materials[1].drainage = drainage;
    c.bodies[0].material = "ground";
    Simulation s(with_fill(c, body("fill", {0.0, 1.0}, {4.0, 1.5}), 1.0));
    run_stages(s, 1);
    const Real before = stress_at_base(s.state);
    s.step(10);
    Real fastest = 0.0;
    for (const Point& p : points_by_id(s.state))
      if (p.material == 1) fastest = std::max(fastest, std::hypot(p.v[0], p.v[1]));
    EXPECT_LT(fastest, 0.02 * g * 10.0 * s.model.dt) << "2 % of a free fall";
    run_stages(s, 2);
    EXPECT_NEAR(stress_at_base(s.state) - before, -(of_fill * g - 9810.0) * 0.5, 0.03 * of_fill * g * 0.5);
  }
}

TEST(PlacedBodies, GoOnFromACheckpointAndOnTwoThreadsWithTheSameBits)
{
  const Case c = ground_and_fill(1.0, 3.0);
  Simulation s(c);
  std::vector<Real> ends;
  for (std::size_t k = 1; k < 3; ++k) run_stages(s, k), ends.push_back(s.state.time);
  const Real removal = ends[1] + 0.5, dt = s.model.dt;
  expect_same_bits(c, {2},
      {0.5 * ends[0], ends[0], ends[0] + 0.2, ends[1], ends[1] + 0.2, removal - dt, removal, removal + dt,
          removal + 0.1});
}

// With the strengths of the case, and without a limit of strength.
TEST(PlacedBodies, AreNotThereInTheSearchForEquilibrium)
{
  for (const Real strength : {1.0, 0.5}) {
    Case alone = settling();
    alone.materials[0].name = "ground", alone.bodies[0].material = "ground";
    alone.initial.stress = InitialStress::equilibrium;
    alone.at_strength = strength;
    Case c = alone;
    c.materials.push_back(elastic(1e6, 0.3, of_fill));
    c.materials.back().name = "fill";
    Simulation s(with_fill(c, body("fill", {1.0, 1.0}, {3.0, 1.5}), 0.5)), without(alone);
    s.step(1), without.step(1);
    EXPECT_EQ(s.state.equilibrium_steps, without.state.equilibrium_steps);
    EXPECT_EQ(s.state.points.n_points(), without.state.points.n_points());
    EXPECT_NEAR(stress_at_base(s.state), stress_at_base(without.state), 1e-6 * of_ground * g);
  }
}

Simulation begun(const Case& other, const StateImage& image, const Case& c)
{
  Model before = build_model(other, 1), model = build_model(c, 1);
  State state = restore(before, image);
  before = model_for(std::move(before), state);
  begin_from(before, "", model, state);
  return Simulation(std::move(model), std::move(state));
}

TEST(PlacedBodies, OfARunThatBeginsWithAnotherAreThoseOfItsCase)
{
  const Case c = ground_and_fill(1.0, 3.0);
  Simulation first(c);
  run_stages(first, 1);
  const Real before = stress_at_base(first.state);
  run_stages(first, 2);
  Simulation anew = begun(c, first.save(), c);
  EXPECT_EQ(anew.state.points.n_points(), 1600) << "the first stage has no fill";
  EXPECT_NEAR(anew.state.mass_removed, of_fill * 2.0 * 0.5, 1e-6);
  anew.run();
  EXPECT_NEAR(stress_at_base(anew.state), before, 0.003 * -before) << "the fill is dug away again";
  EXPECT_NEAR(anew.state.mass_placed, 2.0 * of_fill * 2.0 * 0.5, 1e-6);
  const TableRow row = keep_ledger(anew.model, anew.state, anew.work);
  EXPECT_NEAR(row["mass"] + row["mass_removed"] - row["mass_placed"], of_ground * 4.0, 1e-6);
}

// Points of bodies that are there together are numbered by cells, and others behind them.
TEST(PlacedBodies, MustGiveThePointsTheSameNumbersWhereARunBeginsWithAnother)
{
  Case together = settling();
  together.materials.push_back(elastic(1e6, 0.3, of_fill));
  together.materials[0].name = "ground", together.materials[1].name = "fill";
  together.bodies = {body("ground", {0.0, 0.0}, {2.0, 1.0}), body("fill", {2.0, 0.0}, {4.0, 1.0})};
  together.time.end = 0.05;
  Simulation first(together);
  first.run();
  Case c = together;
  c.bodies.pop_back();
  EXPECT_THAT(refusal<InputError>([&] { begun(together, first.save(), with_fill(c, together.bodies.back(), 0.5)); }),
      HasSubstr("the points of the other run have other numbers"));
}

TEST(PlacedBodies, OnesThatAreNotThereAreMarkedInFrames)
{
  Simulation s(ground_and_fill(1.0, 3.0, 0.1));
  const auto absent = [&] {
    const Frame frame = make_frame(s.model, s.state);
    Index n = 0;
    for (const PointField& field : frame.fields)
      if (field.name == "material")
        for (std::size_t k = 0; k < field.values.size(); ++k)
          if (field.values[k] == -1.0) {
            ++n;
            EXPECT_EQ(frame.x[2 * k], s.state.x_initial[2 * k]);
            EXPECT_GT(frame.x[2 * k + 1], 1.0);
          }
    return n;
  };
  EXPECT_EQ(absent(), 400);
  run_stages(s, 2);
  EXPECT_EQ(absent(), 0);
  run_stages(s, 3);
  EXPECT_EQ(absent(), 400);
}

// A pit is dug and filled with other soil: both are drawn at one place, at different times.
TEST(PlacedBodies, MayFillThePlaceOfOneThatIsGone)
{
  Case c = settling();
  c.time.rest_time = 0.2;
  c.materials.push_back(elastic(1e6, 0.3, of_fill));
  c.materials[0].name = "ground", c.materials[1].name = "fill";
  c.bodies = {body("ground", {0.0, 0.0}, {4.0, 0.5}), body("ground", {0.0, 0.5}, {4.0, 1.0}),
      body("fill", {0.0, 0.5}, {4.0, 1.0})};
  c.bodies[1].removed = 2, c.bodies[2].placed = 3, c.bodies[2].is_there = false;
  StageCase dig = resting("dig", 5.0), fill = resting("fill", 5.0);
  dig.ramp = fill.ramp = 0.5;
  const auto chain = [&](const Case& of) {
    return staged(of, {{resting("settle", 5.0), {}}, {dig, [](Case& now) { now.bodies[1].is_there = false; }},
                          {fill, [](Case& now) { now.bodies[2].is_there = true; }}});
  };
  Simulation s(chain(c));
  s.run();
  EXPECT_NEAR(stress_at_base(s.state), -(of_ground * 0.375 + of_fill * 0.5) * g, 200.0);
  c.bodies[2].placed = 2;
  Model model = build_model(chain(c), 1);
  EXPECT_THAT(refusal<InputError>([&] { build_state(model); }), HasSubstr("body 2 is placed where body 1 is"));
}

TEST(PlacedBodies, WhereSoilHasMovedToStopTheRun)
{
  Case c = column("mpm_gp");
  c.bodies.push_back(body("clay", {8.0, 0.0}, {9.0, 0.5}));
  c.bodies.back().placed = 2, c.bodies.back().is_there = false;
  Simulation s(
      staged(c, {{stage("slide", 1.5), {}}, {stage("late", 0.5), [](Case& n) { n.bodies[1].is_there = true; }}}));
  EXPECT_THAT(refusal<RunError>([&] { s.run(); }), HasSubstr("soil has moved to where the stage `late` places a body"));
}

// Strength of soil that was there belongs to what lay above it then; that of the fill to its own section.
TEST(PlacedBodies, LeaveTheStrengthOfTheSoilBelowThem)
{
  constexpr std::size_t su_peak = 2;
  Case c = column("mpm_gp");
  c.forces.gravity = {0.0, -g};
  c.materials[0].fields = {{su_peak, [](const PlaceInSoil& at) { return 20e3 + at.ground->mass_above(at.x) * g; }}};
  c.bodies.push_back(body("clay", {0.0, 2.0}, {4.0, 3.0}));
  c.bodies.back().placed = 2, c.bodies.back().is_there = false;
  StageCase last = stage("weaker", 0.02);
  last.changes = {{"material.clay.eta", "9"}};  // its fields are set anew
  Simulation s(staged(
      c, {{stage("a", 0.02), {}}, {stage("fill", 0.02), [](Case& n) { n.bodies[1].is_there = true; }}, {last, {}}}));
  run_stages(s, 3);
  const SoilMaterial& soil = s.model.materials[0];
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Real y = s.state.x_initial[2 * id + 1], top = y > 2.0 ? 3.0 : 2.0;
    EXPECT_NEAR(*soil.view(block, lane).parameters(0), 20e3 + soil.density * g * (top - y), 1e-6);
  });
}

// The fill is there from the start; the load on it, which stood before, goes to the ground below when the fill goes.
TEST(PlacedBodies, ThatGoLeaveTheLoadOnThemToTheGroundBelow)
{
  Case c = settling();
  c.time.rest_time = 0.2;
  c.bodies.push_back(c.bodies[0]);
  c.bodies[1].name = "fill";
  c.bodies[1].polygon = body("fill", {0.0, 1.0}, {4.0, 1.5}).polygon;
  c.bodies[1].removed = 2;
  c.loads.push_back({.name = "road", .from = 0.5, .to = 3.5, .pressure = 4e3});
  StageCase dig = resting("dig", 8.0);
  dig.ramp = 0.5;
  Simulation s(staged(c, {{resting("settle", 8.0), {}}, {dig, [](Case& now) { now.bodies.back().is_there = false; }}}));
  const auto force = [&] {
    Real width = 0.0;
    for_each_point(s.state.points,
        [&](const PointBlock<2>& block, Index lane) { width += block.row(loads_of(s.model)[0].row)[lane]; });
    return width * loads_of(s.model)[0].pressure;
  };
  EXPECT_NEAR(force(), 12e3, 1e-6);
  const Real with_fill = (run_stages(s, 1), stress_at_base(s.state));
  run_stages(s, 2);
  EXPECT_NEAR(force(), 12e3, 1e-6);
  EXPECT_NEAR(stress_at_base(s.state) - with_fill, of_ground * g * 0.5, 0.02 * of_ground * g * 0.5);
}

TEST(PlacedBodies, ThatGoWithTheLoadOnThemNeedNoGroundBelow)
{
  Case c = settling();
  c.bodies.push_back(c.bodies[0]);
  c.bodies[0].polygon = body("ground", {0.0, 0.0}, {2.0, 1.0}).polygon;
  c.bodies[1].name = "fill", c.bodies[1].polygon = body("fill", {2.0, 0.0}, {4.0, 1.0}).polygon;
  c.bodies[1].removed = 2;
  c.loads.push_back({.name = "road", .from = 2.5, .to = 3.5, .pressure = 4e3});
  const auto dig = [&](Real pressure) {
    const auto change = [=](Case& now) { now.bodies.back().is_there = false, now.loads[0].pressure = pressure; };
    Simulation s(staged(c, {{stage("settle", 0.05), {}}, {ramped("dig", 0.1, 0.05), change}}));
    run_stages(s, 2);
    return s.state.time;
  };
  EXPECT_THAT([&] { dig(4e3); }, ThrowsMessage<RunError>(HasSubstr("digs the ground away from")));
  EXPECT_NEAR(dig(0.0), 0.15, 0.01);
}

}  // namespace placed_bodies_test
