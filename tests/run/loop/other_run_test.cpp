#include "mpm/features/loads.hpp"
#include "run/loop/other_run.hpp"
#include "run/loop/stages.hpp"
#include "support/simulations.hpp"
#include "support/stages.hpp"

namespace other_run_test {

/// A run of the case that begins with the present state of another one, after its stage.
Simulation continued(const Simulation& other, const std::string& stage, const Case& c)
{
  Model before = build_model(other.model.whole(), 1);
  State state = restore(before, other.save());
  before = model_for(std::move(before), state);
  Model model = build_model(c, 1);
  begin_from(before, stage, model, state);
  return Simulation(std::move(model), std::move(state));
}

/// The case of the name of its water in a box of soil, full to its top at 1 m; K0 at rest.
Case wet(Drainage drainage)
{
  Case c = settling();
  c.materials[0].drainage = drainage;
  c.water.start.phreatic_line = {{0.0, 1.0}};
  c.initial.stress = InitialStress::k0;
  c.initial.k0 = 0.5;
  c.time.end = 0.1;
  return c;
}

Real kinetic_and_given(const Simulation& s)
{
  return kinetic_energy(points_by_id(s.state)) + std::abs(s.state.work.given());
}

Real mass_of(const State& state)
{
  Real mass = 0.0;
  for (const Point& p : points_by_id(state)) mass += p.mass;
  return mass;
}

/// Sum of the stretch that the points carry of a load [m].
Real carried(const Simulation& s, std::size_t load)
{
  Real sum = 0.0;
  for_each_point(s.state.points,
      [&](const PointBlock<2>& block, Index lane) { sum += block.row(loads_of(s.model)[load].row)[lane]; });
  return sum;
}

TEST(OtherRun, GivesWayToTheFieldsOfThisOne)
{
  constexpr std::size_t su_peak = 2;
  Case c = column("mpm_gp");
  c.time.end = 0.1;
  c.materials[0].fields = {{su_peak, [](Vec<2> x) { return 15e3 + 1e3 * x[1]; }}};
  Simulation first(c);
  first.run();
  c.materials[0].fields = {{su_peak, [](Vec<2> x) { return 9e3 + 1e3 * x[1]; }}};
  const Simulation s = continued(first, "", c);
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    EXPECT_EQ(*s.model.materials[0].view(block, lane).parameters(0), 9e3 + 1e3 * s.state.x_initial[2 * id + 1]);
  });
}

TEST(OtherRun, OfAnotherTimeStepKeepsTheTime)
{
  Case slow = settling(), fast = settling();
  fast.materials[0].parameters[0] *= 4.0;  // half of the time step
  Simulation first(staged(slow, {{stage("a", 0.2), {}}, {stage("b", 0.2), {}}}));
  first.advance_to(0.2);
  const Case chain = staged(fast, {{stage("a", 0.2), {}}, {stage("b", 0.2), {}}});
  Simulation s = continued(first, "a", chain);
  s.step(1);
  EXPECT_NEAR(s.state.time, first.state.time + s.model.dt, 1e-12);
  s.run();
  EXPECT_NEAR(s.state.time, 0.4, 2.0 * s.model.dt);
  Simulation again(build_model(chain, 1), restore(s.model, s.save()));
  EXPECT_EQ(again.model.first_time, first.state.time);
}

// The stress of the points differs by the water of the run that they come from.
TEST(OtherRun, WithAnotherDrainageLeavesSoilAtRest)
{
  for (const auto& [was, is] :
      {std::pair(Drainage::drained, Drainage::undrained), std::pair(Drainage::undrained, Drainage::drained)}) {
    Simulation first(wet(was));
    first.run();
    Case c = wet(is);
    c.water.situations = {{.name = "low", .phreatic_line = {{0.0, 0.0}}}};  // must not count
    Simulation s = continued(first, "", c);
    const Real before = kinetic_and_given(s);
    s.run();
    EXPECT_LT(kinetic_and_given(s) - before, 1e-3);  // 5e1 J where the stress stays as it was
  }
}

TEST(OtherRun, WithAnotherDensityHasItsMass)
{
  Case c = settling();
  c.initial.stress = InitialStress::k0;
  c.time.end = 0.05;
  Simulation first(c);
  first.run();
  c.materials[0].density *= 0.75;
  EXPECT_DOUBLE_EQ(mass_of(continued(first, "", c).state), 0.75 * mass_of(first.state));
}

TEST(OtherRun, PutsOnTheLoadsThatAreDue)
{
  Case c = settling();
  c.time.end = 0.05;
  c.loads = {{.name = "kept", .from = 0.5, .to = 1.5, .pressure = 1e3},
      {.name = "moves", .from = 0.5, .to = 1.5, .pressure = 1e3},
      {.name = "was none", .from = 0.5, .to = 1.5, .pressure = 0.0}};
  Simulation first(c);
  first.run();
  c.loads = {{.name = "moves", .from = 2.0, .to = 2.5, .pressure = 1e3},
      {.name = "was none", .from = 0.5, .to = 1.5, .pressure = 1e3},
      {.name = "kept", .from = 0.5, .to = 1.5, .pressure = 1e3},
      {.name = "began", .from = 1.0, .to = 3.0, .pressure = 1e3, .start = 0.02},
      {.name = "late", .from = 1.0, .to = 3.0, .pressure = 1e3, .start = 0.06}};
  Simulation s = continued(first, "", c);
  EXPECT_NEAR(carried(s, 0), 0.5, 1e-12);
  EXPECT_NEAR(carried(s, 1), 1.0, 1e-12);
  EXPECT_NEAR(carried(s, 2), 1.0, 1e-12);
  EXPECT_NEAR(carried(s, 3), 2.0, 1e-12);
  EXPECT_EQ(carried(s, 4), 0.0);
  s.run();
  EXPECT_NEAR(carried(s, 4), 2.0, 1e-12);
  c.loads = {{.name = "beside", .from = 3.0, .to = 7.0, .pressure = 1e3}};
  EXPECT_THAT(refusal<InputError>([&] { continued(first, "", c); }),
      HasSubstr("load[0].from: there is no ground under the load `beside` where the run begins"));
}

TEST(OtherRun, WithNothingLeftToDoIsRefused)
{
  const Case chain = staged(settling(), {{stage("a", 0.05), {}}, {stage("b", 0.05), {}}});
  Simulation whole(chain);
  whole.run();
  EXPECT_THAT(refusal<InputError>([&] { continued(whole, "b", chain); }),
      AllOf(HasSubstr("the run begins with the end of the stage `b`, the last of this case"),
          HasSubstr("Add one after it, begin with the end of an earlier one")));
}

TEST(OtherRun, GoesOnFromItsOwnCheckpoints)
{
  Case c = settling();
  c.time.end = 0.1;
  Simulation first(c);
  first.run();
  Case chain = staged(c, {{ramped("a", 0.1, 0.1), [](Case& n) { n.forces.gravity = {0.0, -20.0}; }}});
  for (const Case& second : {c, chain}) {
    Simulation whole = continued(first, "", second), half = continued(first, "", second);
    whole.run();
    half.step(whole.model.n_steps / 2);
    Simulation again(build_model(second, 1), restore(build_model(second, 1), half.save()));
    again.run();
    EXPECT_NEAR(again.state.time, 0.2, 1e-9);
    EXPECT_EQ(first_difference(whole.save(), again.save()), "");
  }
}

}  // namespace other_run_test
