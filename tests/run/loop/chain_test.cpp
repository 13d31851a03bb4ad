#include "model/water/nodal_water.hpp"
#include "mpm/features/loads.hpp"
#include "run/loop/other_run.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/soil_fields.hpp"
#include "run/loop/stages.hpp"
#include "support/simulations.hpp"
#include "support/stages.hpp"

namespace chain_test {

MaterialCase frictional(const std::string& name, Real cohesion, Drainage drainage)
{
  MaterialCase m{name, "mohr_coulomb", 2000.0, {2e6, 0.3, cohesion, 30.0, 0.0, INFINITY, cohesion, 30.0, 0.0, 0.0}};
  m.drainage = drainage;
  return m;
}

/// Sand on clay, 4 m x 1 m, under water to the top; a load behind all other rows.
Case layers()
{
  Case c = settling();
  c.materials = {frictional("clay", 1e3, Drainage::undrained), frictional("sand", 100.0, Drainage::drained)};
  c.bodies = {body("clay", {0.0, 0.0}, {4.0, 0.5}), body("sand", {0.0, 0.5}, {4.0, 1.0})};
  c.water.start.phreatic_line = {{0.0, 1.0}};
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 1.6}}}};
  c.initial.stress = InitialStress::k0;
  c.initial.k0 = 0.6;
  c.loads = {{.name = "q", .from = 0.5, .to = 1.5, .pressure = 6e3}};
  return c;
}

/// Half of the soil below y = 0.5 m is as stiff as this [Pa].
void stiffen_field(Case& c, Real shear_modulus)
{
  c.materials[0].fields = {{0, [shear_modulus](Vec<2> x) { return x[0] < 2.0 ? shear_modulus : 0.5 * shear_modulus; }}};
}

Simulation after_stage(const Case& chain, const StateImage& image, const std::string& stage)
{
  Model before = build_model(chain, 1), model = build_model(chain, 1);
  State state = restore(before, image);
  before = model_for(std::move(before), state);
  begin_from(before, stage, model, state);
  return Simulation(std::move(model), std::move(state));
}

TEST(Chain, KeepsTheRowsOfThePointsThroughAllStages)
{
  const auto drain = [](Drainage drainage) { return [drainage](Case& c) { c.materials[0].drainage = drainage; }; };
  for (const Drainage first : {Drainage::drained, Drainage::undrained, Drainage::undrained_effective})
    for (const Drainage second : {Drainage::drained, Drainage::undrained, Drainage::undrained_effective}) {
      Simulation s(staged(layers(), {{stage("a", 0.3), drain(first)}, {stage("b", 0.01), drain(second)}}));
      s.advance_to(0.3);
      const RowTable rows = s.model.rows;
      const std::vector<Point> before = points_by_id(s.state);
      const int load = loads_of(s.model)[0].row, strain = row_of(s.model.materials[1], Role::plastic_strain);
      enter_next_stage(s.model, s.state, s.work);
      EXPECT_TRUE(s.model.rows == rows);
      EXPECT_EQ(loads_of(s.model)[0].row, load);
      EXPECT_EQ(row_of(s.model.materials[1], Role::plastic_strain), strain);
      const std::vector<Point> after = points_by_id(s.state);
      Real largest = 0.0;
      for (std::size_t k = 0; k < before.size(); ++k) {
        EXPECT_EQ(after[k].eps_eq_p(), before[k].eps_eq_p());
        largest = std::max(largest, after[k].eps_eq_p());
      }
      EXPECT_GT(largest, 1e-6);
    }
}

TEST(Chain, LeavesSoilAtRestWhereItsDrainageChanges)
{
  Case c = layers();
  for (MaterialCase& m : c.materials) m.parameters[2] = m.parameters[6] = 20e3;
  Simulation s(staged(c, {{stage("a", 0.4), {}}, {stage("b", 0.4), [](Case& n) {
                                                    n.materials[0].drainage = Drainage::undrained_effective;
                                                  }}}));
  s.advance_to(0.4);
  const Real base = points_by_id(s.state)[0].x[1];
  s.run();
  EXPECT_NEAR(points_by_id(s.state)[0].x[1], base, 1e-4);
  EXPECT_LT(kinetic_energy(points_by_id(s.state)), 1.0);
}

TEST(Chain, HasTheTimeStepOfItsStiffestStage)
{
  for (const Drainage drainage : {Drainage::undrained, Drainage::undrained_effective}) {
    Case c = layers();
    c.materials[0].drainage = drainage;
    stiffen_field(c, 32e6);
    c.time.end = 0.1;
    const Real dt = build_model(c, 1).dt;
    stiffen_field(c, 2e6);
    Simulation s(staged(c, {{stage("a", 0.06), {}}, {stage("b", 0.04), [](Case& n) { stiffen_field(n, 32e6); }}}));
    EXPECT_EQ(s.model.dt, dt);
    s.advance_to(0.06);
    const Real time = s.state.time;
    s.step(1);
    EXPECT_EQ(s.model.stage.number, 1u);
    EXPECT_EQ(s.model.dt, dt);
    EXPECT_NEAR(s.state.time, time + dt, 1e-12);
    s.run();
    EXPECT_NEAR(s.state.time, 0.1, 1e-12);
  }
}

/// Resumed or begun with the end of any of its stages, a chain ends in the bits of the whole run.
void expect_same_bits_from_everywhere(const Case& chain)
{
  Simulation whole(chain), first(chain);
  whole.run();
  const StateImage end = whole.save();
  std::vector<StateImage> ends;
  for (std::size_t k = 0; k + 1 < chain.stages.size(); ++k) {
    while (first.state.stages_done.size() <= k) first.step(1);
    ends.push_back(first.save());
    Simulation resumed(build_model(chain, 1), restore(first.model, ends.back()));
    resumed.run();
    EXPECT_EQ(first_difference(end, resumed.save()), "") << k;
    Simulation from = after_stage(chain, ends.back(), chain.stages[k].name);
    from.run();
    EXPECT_EQ(different_arrays(end, from.save()), (std::vector<std::string>{"counts", "rows_reported/ledger"})) << k;
  }
  for (const StateImage& image : {ends[2], ends[0], ends[1]}) {  // also back to an earlier stage
    whole.restore(image);
    whole.run();
    EXPECT_EQ(first_difference(end, whole.save()), "");
  }
}

// With all that a stage may change: gravity, drainage, water, a field of stiffness, loads, materials of bodies.
TEST(Chain, EndsInTheSameBitsFromWhereverItGoesOn)
{
  Case c = layers();
  stiffen_field(c, 2e6);
  c.materials.push_back(frictional("berm", 2e3, Drainage::drained));
  c.materials.back().density = 1800.0;
  StageCase flood = ramped("flood", 0.1, 0.05), late = ramped("late", 0.1, 0.05);
  flood.water = "high";
  late.reset_displacement = true;
  const Case chain = staged(c, {{stage("light", 0.1),
                                    [](Case& n) {
                                      n.forces.gravity = {0.0, -6.0};
                                    }},
                                   {ramped("heavy", 0.1, 0.06),
                                       [](Case& n) {
                                         n.forces.gravity = {0.0, -10.0};
                                       }},
                                   {flood, [](Case& n) { n.materials[0].drainage = Drainage::undrained_effective; }},
                                   {late, [](Case& n) {
                                      stiffen_field(n, 8e6);
                                      n.loads[0].pressure = 9e3;
                                      n.bodies[1].material = "berm";
                                      n.materials[0].drainage = Drainage::drained;
                                    }}});
  expect_same_bits_from_everywhere(chain);
}

// Bodies come and go over ramps, the last one until the end; their stiffness follows the weight above it.
TEST(Chain, EndsInTheSameBitsWhereBodiesComeAndGo)
{
  Case c = layers();
  c.loads.clear();
  c.materials.push_back(frictional("berm", 2e3, Drainage::drained));
  for (MaterialCase& m : c.materials)
    m.fields = {{0, [](const PlaceInSoil& at) { return 1e6 + 50.0 * at.ground->mass_above(at.x); }}};
  c.bodies.push_back(body("berm", {1.0, 1.0}, {3.0, 1.25}));
  c.bodies.push_back(body("berm", {3.0, 1.0}, {4.0, 1.25}));
  c.bodies[2].placed = 2, c.bodies[2].removed = 3, c.bodies[3].placed = 4;
  c.bodies[2].is_there = c.bodies[3].is_there = false;
  StageCase flood = ramped("flood", 0.1, 0.05);
  flood.water = "high", flood.reset_displacement = true;
  const Case chain =
      staged(c, {{stage("settle", 0.1), {}}, {ramped("berm", 0.1, 0.06), [](Case& n) { n.bodies[2].is_there = true; }},
                    {ramped("dig", 0.1, 0.06), [](Case& n) { n.bodies[2].is_there = false; }},
                    {flood, [](Case& n) { n.bodies[3].is_there = true; }}});
  expect_same_bits_from_everywhere(chain);
}

// A strength that follows from the weight above it belongs to the ground at t = 0.
TEST(Chain, KeepsStrengthsOfTheGroundWithWhichItBegan)
{
  constexpr std::size_t su_peak = 2, eta = 4;
  Case c = settling();
  c.materials = {clay({.eta = 5.0})};
  c.bodies = {body("clay", {0.0, 0.0}, {4.0, 1.0})};
  c.materials[0].fields = {{su_peak, by_stress({{0.0, 5e3}, {100e3, 45e3}}, "")}};
  c.initial.stress = InitialStress::k0;
  StageCase second = stage("b", 0.02);
  second.changes = {{"material.clay.eta", "4.9"}};
  Simulation s(staged(c, {{stage("a", 0.02), {}}, {second, [](Case& n) {
                                                     n.forces.gravity = {0.0, -5.0};
                                                     n.materials[0].parameters[eta] = 4.9;
                                                   }}}));
  const auto strengths = [](const Simulation& s) {
    std::map<Real, Real> by_id;
    for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
      by_id[block.row(Rows::id)[lane]] = *s.model.materials[0].view(block, lane).parameters(0);
    });
    return by_id;
  };
  const auto first = strengths(s);
  s.run();
  EXPECT_EQ(s.model.stage.number, 1u);
  EXPECT_EQ(strengths(s), first);
  c.time.end = 0.02;
  c.loads = {{.name = "traffic", .from = 0.0, .to = 4.0, .pressure = 13e3}};
  EXPECT_EQ(strengths(Simulation(c)), first);  // a load gives none
}

/// Elastic soil at rest under what acts at t = 0.
Case at_rest()
{
  Case c = settling();
  c.initial.stress = InitialStress::k0;
  c.initial.k0 = 0.3 / 0.7;  // that of elastic soil between walls
  c.loads = {{.name = "q", .from = 0.0, .to = 4.0, .pressure = 0.0}};
  return c;
}

// Gravity, loads and water of the first stage act in full at once, or begin their ramp from those of the case.
TEST(Chain, BeginsWithTheStressOfWhatActsAtItsStart)
{
  Case wet = at_rest();
  wet.materials[0].drainage = Drainage::drained;
  wet.water.start.phreatic_line = {{0.0, 0.0}};
  wet.water.situations = {{.name = "high", .phreatic_line = {{0.0, 1.0}}}};
  StageCase flood = stage("flood", 0.1);
  flood.water = "high";
  const auto load = [](Case& n) { n.loads[0].pressure = 50e3; };
  const auto gravity = [](Case& n) { n.forces.gravity = {0.0, -20.0}; };
  for (const Case& chain : {staged(at_rest(), {{ramped("load", 0.1, 50.0), load}}),
           staged(at_rest(), {{stage("load", 0.1), load}}), staged(at_rest(), {{ramped("heavy", 0.1, 50.0), gravity}}),
           staged(at_rest(), {{stage("heavy", 0.1), gravity}}), staged(wet, {{flood, {}}})}) {
    Simulation s(chain);
    s.run();
    EXPECT_LT(kinetic_energy(points_by_id(s.state)), 0.5) << chain.stages[0].name << ' ' << chain.stages[0].ramp;
  }
}

// The water follows the weight: soil that gravity puts on in steps is not lifted by the water of its end.
TEST(Chain, CutsTheWaterToTheWeightOfTheStep)
{
  Case c = settling();
  c.materials = {frictional("soil", 100.0, Drainage::drained)};
  c.bodies = {body("soil", {0.0, 0.0}, {4.0, 1.0})};
  c.forces.gravity = {0.0, 0.0};
  c.water.start.phreatic_line = {{0.0, 1.0}};
  Simulation s(staged(c, {{ramped("up", 1.0, 0.8), [](Case& n) { n.forces.gravity = {0.0, -10.0}; }}}));
  Real highest = 0.0;
  while (s.state.time < 0.999) {
    s.step(20);
    const PorePressure pore = water_at(s.model, s.state.time);
    const Real g = -s.model.gravity_at(s.state.time)[1];
    for (Index i = 0; i < s.model.mesh->n_nodes(); ++i)
      if (s.model.mesh->nodes[i][1] < 1e-9) {
        EXPECT_LE(pore.pressure[i], 2000.0 * g * 1.0 * (1.0 + 1e-12));
      }
    for (const Point& p : points_by_id(s.state)) highest = std::max(highest, p.x[1]);
  }
  EXPECT_LT(highest, 1.0);
}

}  // namespace chain_test
