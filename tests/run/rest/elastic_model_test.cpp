#include "run/rest/elastic_model.hpp"
#include "model/parts/reduce.hpp"
#include "support/simulations.hpp"

namespace elastic_model_test {

/// A vertical cut of 2 m on a rough base, cells of 0.5 m: its factor of safety is 0.92 to 0.94 (decision 0035).
Case cut(Real at_strength)
{
  Case c = column_without_softening("mpm_mixed");
  for (SideCondition& side : c.sides)
    if (side.side == "bottom") side.kind = SideKind::fixed;
  c.initial.stress = InitialStress::equilibrium;
  c.at_strength = at_strength;
  c.forces.local_damping = 0.1;
  c.time.end = 1.5;
  return c;
}

/// How far the soil came beyond its toe, which is at x = 8 [m].
Real run_out(const Case& c)
{
  Simulation s(c);
  s.run();
  Real front = 0.0;
  for (const Point& p : points_by_id(s.state)) front = std::max(front, p.x[0]);
  return front - 8.0;
}

TEST(AtStrength, TheLawsGetTheStrengthsDivided)
{
  const Simulation s(cut(0.8));
  EXPECT_DOUBLE_EQ(s.model.description.materials[0].parameters[2], 1e4);
  Case varies = cut(0.8);
  varies.materials[0].fields = {{2, [](Vec<2> x) { return 8e3 + 100.0 * x[1]; }}};
  const Simulation f(varies);
  for (const Point& p : points_by_id(f.state)) EXPECT_DOUBLE_EQ(p.values.back(), (8e3 + 100.0 * p.x[1]) / 0.8);
}

TEST(AtStrength, OneChangesNoBit)
{
  Case c = column("mpm_gp"), divided = c;
  c.time.end = divided.time.end = 0.05;
  for (MaterialCase& m : divided.materials) m.parameters[2] *= 1.25, m.parameters[3] *= 1.25;
  for (SideCondition& side : divided.sides) side.adhesion *= 1.25;
  divided.at_strength = 1.25;
  Simulation a(c), b(divided);
  a.run(), b.run();
  EXPECT_EQ(first_difference(a.save(), b.save()), "") << "times and over 1.25 is exact";
}

TEST(AtStrength, JustAboveTheFactorOfSafetyItFailsAndBelowItStands)
{
  const Real stands = run_out(cut(0.88)), fails = run_out(cut(1.01));
  EXPECT_LT(stands, 0.1);
  EXPECT_GT(fails, 3.0 * stands);
  EXPECT_GT(fails, 0.1) << "until it is flat enough to stand";
}

TEST(AtStrength, BeginsAtRestWhereTheSoilCannotStand)
{
  Simulation s(cut(0.99));
  EXPECT_EQ(s.start(), Outcome::finished);
  EXPECT_GT(s.state.equilibrium_steps, 10);
  EXPECT_EQ(s.state.time, 0.0);
  Real largest = 0.0;
  for (const Point& p : points_by_id(s.state)) {
    EXPECT_EQ(p.v, (Vec<2>{0.0, 0.0}));
    EXPECT_EQ(p.eps_eq_p(), 0.0);
    largest = std::max(largest, 0.5 * std::hypot(p.sigma[0] - p.sigma[1], 2.0 * p.sigma[3]));
  }
  EXPECT_GT(largest, 8e3 / 0.99) << "no strength limits the stress of the start";
}

TEST(AtStrength, StagesDoNotGiveTheSoilItsStrengthBackInTheSearch)
{
  const Case plain = cut(0.99);
  StageCase stage;
  stage.name = "only";
  stage.duration = plain.time.end;
  stage.changed = std::make_shared<const Case>(plain);
  Case staged = plain;
  staged.stages = {stage};
  Simulation s(plain), t(staged);
  s.start(), t.start();
  const auto a = points_by_id(s.state), b = points_by_id(t.state);
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_EQ(a[k].sigma, b[k].sigma);
}

TEST(AtStrength, BeginsInTheSectionAsDrawn)
{
  Simulation s(cut(1.0 / 0.7));
  const std::vector<Real> drawn = s.state.x_initial;
  s.start();
  for (const Point& p : points_by_id(s.state))
    for (int d = 0; d < 2; ++d) EXPECT_EQ(p.x[d], drawn[2 * static_cast<std::size_t>(p.id) + d]);
}

TEST(AtStrength, ASearchThatWasStoppedBeginsAnew)
{
  Simulation stopped(cut(0.95)), whole(cut(0.95));
  EXPECT_EQ(stopped.start(std::atomic<bool>{true}), Outcome::interrupted);
  EXPECT_EQ(stopped.state.equilibrium_steps, 0);
  EXPECT_EQ(stopped.start(), Outcome::finished);
  EXPECT_EQ(whole.start(), Outcome::finished);
  EXPECT_EQ(first_difference(stopped.save(), whole.save()), "");
}

TEST(AtStrength, WithFieldsThePointsHaveTheirOwnStrengthsAfterTheSearch)
{
  Case c = cut(0.9);
  c.materials[0].fields = {{2, [](Vec<2> x) { return 8e3 + 500.0 * x[1]; }}};
  Simulation s(c);
  const std::vector<Real> places = s.state.x_initial;
  s.start();
  for (const Point& p : points_by_id(s.state))
    EXPECT_DOUBLE_EQ(p.values.back(), (8e3 + 500.0 * places[2 * static_cast<std::size_t>(p.id) + 1]) / 0.9);
}

TEST(ElasticModel, HasTheStiffnessOfTheSoilAndNoStrength)
{
  const Case c = cut(1.0);
  const Simulation s(c);
  const Model elastic = build_elastic_model(c, s.model.mesh, 1, s.model.rows);
  EXPECT_EQ(elastic.materials[0].type->name, "linear_elastic");
  EXPECT_DOUBLE_EQ(elastic.materials[0].law->shear_modulus(), 2e6);
  for (const RowInfo& row : s.model.rows.added())
    EXPECT_TRUE(std::ranges::any_of(elastic.rows.entries(), [&](const RowInfo& e) { return e.name == row.name; }));
}

}  // namespace elastic_model_test
