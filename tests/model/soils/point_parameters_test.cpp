#include "model/soils/point_parameters.hpp"
#include "run/report/frame.hpp"
#include "support/simulations.hpp"

namespace point_parameters_test {

const std::vector<const char*> schemes = {"standard_mpm", "mpm_mixed", "mpm_gp"};
constexpr std::size_t shear_modulus = 0, su_peak = 2, eta = 4;  // numbers in the table of tresca_softening

Case with_field(const std::string& scheme, std::size_t parameter, std::function<Real(Vec<2>)> value_at)
{
  Case c = column(scheme);
  c.materials[0].fields = {{parameter, std::move(value_at)}};
  return c;
}

void expect_refused(const Case& c, const std::string& key, const std::string& what, const std::string& detail)
{
  EXPECT_THAT(problems_of([&] { Simulation s(c); }), ElementsAre(told(key, what, HasSubstr(detail))));
}

const PointField& field_of(const Frame& frame, const std::string& name)
{
  return *std::ranges::find(frame.fields, name, &PointField::name);
}

/// The case with rows of the values that its parameters have.
Case with_rows_of_one_value(Case c)
{
  for (const std::size_t k : {shear_modulus, su_peak, eta})
    c.materials[0].fields.push_back({k, [value = c.materials[0].parameters[k]](Vec<2>) { return value; }});
  return c;
}

// MPM-Mixed takes the mean of the points at a Gauss point. The mean of equal numbers is that number to round-off only,
// which soil that yields amplifies: 1e-16 becomes 1e-6 m in 400 steps with local damping.
TEST(PointParameters, ARowOfOneValueGivesInMixedTheResultsOfTheUniformParameter)
{
  Case c = column("mpm_mixed");
  c.forces.local_damping = 0.0;
  Simulation uniform(c), rows(with_rows_of_one_value(c));
  EXPECT_EQ(rows.model.dt, uniform.model.dt);
  make_steps(uniform, 200);
  make_steps(rows, 200);
  const auto a = points_by_id(uniform.state), b = points_by_id(rows.state);
  Real largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (int d = 0; d < 2; ++d) ASSERT_NEAR(a[k].x[d], b[k].x[d], 1e-10);
    ASSERT_NEAR(a[k].eps_eq_p(), b[k].eps_eq_p(), 1e-9);
    largest = std::max(largest, a[k].eps_eq_p());
  }
  EXPECT_GT(largest, 1e-3) << "nothing yielded: the test says nothing";
}

TEST(PointParameters, ARowOfOneValueGivesTheBitsOfTheUniformParameter)
{
  for (const char* scheme : {"standard_mpm", "mpm_gp"}) {
    Simulation uniform(column(scheme)), rows(with_rows_of_one_value(column(scheme)));
    EXPECT_EQ(rows.model.dt, uniform.model.dt);
    make_steps(uniform, 400);
    make_steps(rows, 400);
    const auto a = points_by_id(uniform.state), b = points_by_id(rows.state);
    Real largest = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_EQ(a[k].x, b[k].x) << scheme;
      ASSERT_EQ(a[k].sigma, b[k].sigma) << scheme;
      ASSERT_EQ(a[k].eps_eq_p(), b[k].eps_eq_p()) << scheme;
      largest = std::max(largest, a[k].eps_eq_p());
    }
    EXPECT_GT(largest, 0.01) << "nothing yielded: the test says nothing";
    EXPECT_EQ(uniform.state.work.plastic, rows.state.work.plastic);
  }
}

TEST(PointParameters, StrongSoilStandsWhereWeakSoilYields)
{
  for (const char* scheme : schemes) {
    Simulation s(with_field(scheme, su_peak, [](Vec<2> x) { return x[0] < 4.0 ? 40e3 : 2.5e3; }));
    make_steps(s, 200);
    for (const Point& p : points_by_id(s.state)) {
      const Real x = s.state.x_initial[2 * static_cast<std::size_t>(p.id)];
      if (x < 2.9) {
        EXPECT_EQ(p.eps_eq_p(), 0.0) << scheme << ", x = " << x;
      }
    }
    const auto points = points_by_id(s.state);
    EXPECT_GT(std::ranges::max(points, {}, &Point::eps_eq_p).eps_eq_p(), 0.01) << scheme;
  }
}

TEST(PointParameters, AreNeverAveragedAndGoWhereTheirPointGoes)
{
  const auto by_height = [](Vec<2> x) { return 8e3 + 1e3 * x[1] + 10.0 * x[0]; };
  for (const char* scheme : schemes) {
    Simulation s(with_field(scheme, su_peak, by_height));
    make_steps(s, 600);
    for (const Point& p : points_by_id(s.state)) {
      const auto id = static_cast<std::size_t>(p.id);
      ASSERT_EQ(p.values[1], by_height({s.state.x_initial[2 * id], s.state.x_initial[2 * id + 1]})) << scheme;
    }
  }
}

TEST(PointParameters,
    MpmMixedUsesTheMeanOfTheSubCell)  // two points in one sub-cell yield at the mean of their strengths
{
  Case c = clamped_cell("mpm_mixed");
  const auto run = [&](const std::function<Real(Vec<2>)>& strength) {
    c.materials[0].fields = {{su_peak, strength}};
    c.materials[0].parameters[eta] = 0.0;
    c.bodies[0].points_per_cell = {4, 2};
    Simulation s(c);
    edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
      block.row(Rows::sigma + 3)[lane] = 20e3;  // far outside of the yield surface
    });
    make_steps(s);
    return points_by_id(s.state);
  };
  const auto mean = run([](Vec<2>) { return 6e3; });
  const auto split = run([](Vec<2> x) { return std::fmod(x[0] * 4.0, 2.0) < 1.0 ? 4e3 : 8e3; });
  for (std::size_t k = 0; k < mean.size(); ++k) EXPECT_NEAR(split[k].sigma[3], mean[k].sigma[3], 1e-9);
  EXPECT_NEAR(mean[0].sigma[3], 6e3, 1e-6);
}

TEST(PointParameters, TheTimeStepTakesTheStiffestPoint)
{
  const Case soft = column("mpm_gp");
  Case stiff = soft;
  stiff.materials[0].parameters[shear_modulus] = 2e6 * 1.95 * 1.95;
  const Case varied =
      with_field("mpm_gp", shear_modulus, [](Vec<2> x) { return x[0] > 7.9 && x[1] > 1.9 ? 2e6 * 1.95 * 1.95 : 2e6; });
  EXPECT_EQ(build_model(varied, 1).dt, build_model(stiff, 1).dt);
  EXPECT_LT(build_model(varied, 1).dt, build_model(soft, 1).dt);
}

TEST(PointParameters, TheElasticEnergyIsThatOfTheStiffnessOfEachPoint)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0});
  c.materials[0].fields = {{shear_modulus, [](Vec<2> x) { return x[0] < 1.25 ? 1e6 : 4e6; }}};
  Simulation s(c);
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) { block.row(Rows::sigma + 3)[lane] = 3e3; });
  const Real expected = 0.125 * 9e6 / 2.0 * (1.0 / 1e6 + 1.0 / 4e6);
  EXPECT_NEAR(keep_ledger(s.model, s.state, s.work)["elastic"], expected, 1e-12);
  EXPECT_NEAR(kinetic_and_stored_energy(s.model, s.state), expected, 1e-12);
}

TEST(PointParameters, AreAFieldOfTheFrameAndInTheCheckpoint)
{
  const Case c = with_field("mpm_mixed", su_peak, [](Vec<2> x) { return 8e3 + 100.0 * x[0]; });
  Simulation s(c);
  const Frame frame = make_frame(s.model, s.state);
  const PointField& given = field_of(frame, "parameter_su_peak");
  EXPECT_EQ(given.unit, "Pa");
  EXPECT_EQ(given.values[3], 8e3 + 100.0 * frame.x[6]);
  EXPECT_DOUBLE_EQ(field_of(frame, "su").values[3], given.values[3]) << "nothing has softened yet";

  s.step(50);
  Simulation rest(build_model(c, 1), restore(s.model, s.save()));
  s.step(50);
  rest.step(50);
  EXPECT_EQ(first_difference(s.save(), rest.save()), "");
  EXPECT_THAT([&] { restore(Simulation(column("mpm_mixed")).model, s.save()); },
      ThrowsMessage<FileError>("the checkpoint does not fit this case: its points carry `parameter_su_peak`, "
                               "which the points of this case do not"));
}

TEST(PointParameters, CostNoRowWhereTheyAreUniform)
{
  EXPECT_EQ(Simulation(column("mpm_gp")).state.points.n_rows(), Rows::state + 1);
  EXPECT_EQ(Simulation(with_field("mpm_gp", eta, [](Vec<2>) { return 50.0; })).state.points.n_rows(), Rows::state + 2);
}

TEST(PointParameters, CanBeSetInARunAndAreChecked)
{
  Simulation s(with_field("mpm_gp", su_peak, [](Vec<2>) { return 8e3; }));
  PointField peak = s.field("parameter_su_peak");
  peak.values[7] = 6e3;
  s.set_field("parameter_su_peak", peak.values);
  EXPECT_EQ(s.field("su").values[7], 6e3);
  EXPECT_EQ(s.field("su").values[8], 8e3);
  peak.values[7] = -1.0;
  EXPECT_THROW(s.set_field("parameter_su_peak", peak.values), InputError);
  EXPECT_EQ(s.field("parameter_su_peak").values[7], 6e3) << "refused, so nothing was set";

  Simulation soft(with_field("mpm_gp", shear_modulus, [](Vec<2>) { return 2e6; }));
  PointField stiffness = soft.field("parameter_shear_modulus");
  stiffness.values[3] = 3e6;
  EXPECT_THAT(problems_of([&] { soft.set_field("parameter_shear_modulus", stiffness.values); }),
      ElementsAre(told(
          _, "a point is too stiff for the time step of the run", HasSubstr("Give the stiffest soil in the case."))));
}

TEST(PointParameters, ThoseThatTheCaseFindsFromOneChangeInProportion)
{
  Case c = with_field("mpm_gp", su_peak, [](Vec<2>) { return 8e3; });
  c.materials[0].fields.insert(c.materials[0].fields.begin(),
      {.parameter = shear_modulus, .value_at = [](Vec<2>) { return 2e6; }, .follows = su_peak});
  Simulation s(c);
  PointField peak = s.field("parameter_su_peak");
  peak.values[7] = 6e3;
  s.set_field("parameter_su_peak", peak.values);
  const PointField stiffness = s.field("parameter_shear_modulus");
  EXPECT_DOUBLE_EQ(stiffness.values[7], 1.5e6);
  EXPECT_EQ(stiffness.values[8], 2e6);
  peak.values[7] = 9e3;
  EXPECT_THAT(problems_of([&] { s.set_field("parameter_su_peak", peak.values); }),
      ElementsAre(told(_, "a point is too stiff for the time step of the run", _)))
      << "by the stiffness that follows";
  EXPECT_DOUBLE_EQ(s.field("parameter_shear_modulus").values[7], 1.5e6) << "refused, so nothing was set";
}

TEST(PointParameters, OfOneMaterialAreNoneOfAnother)  // two laws with different state share one table
{
  Case c = with_field("mpm_gp", su_peak, [](Vec<2>) { return 8e3; });
  c.materials.push_back({"water", "newtonian_fluid", 1000.0, {2e6, 1.0, 0.0}});
  c.bodies.push_back(body("water", {9.0, 0.0}, {12.0, 0.5}));
  Simulation s(c);
  PointField opening = s.field("opening"), peak = s.field("parameter_su_peak");
  std::size_t water = 0, clay = 0;
  for (std::size_t k = 0; k < opening.values.size(); ++k) (std::isnan(opening.values[k]) ? clay : water) = k;
  EXPECT_EQ(peak.values[clay], 8e3);
  EXPECT_TRUE(std::isnan(peak.values[water]));
  opening.values[water] = 0.25;
  s.set_field("opening", opening.values);
  EXPECT_EQ(s.field("opening").values[water], 0.25);
  EXPECT_EQ(s.field("eps_eq_p").values[clay], 0.0);
  EXPECT_TRUE(std::isnan(s.field("eps_eq_p").values[water]));
}

TEST(PointParameters, OutsideOfTheirRangeAtSomePointAreRefused)
{
  expect_refused(with_field("mpm_gp", su_peak, [](Vec<2> x) { return x[0] < 6.0 ? 8e3 : -5.0; }),
      "material.clay.su_peak", "`su_peak` is out of range in part of the soil", "It is -5 Pa at (6.05, 0.05) m,");
  expect_refused(with_field("mpm_gp", su_peak, [](Vec<2> x) { return x[0] < 6.0 ? 8e3 : 1e3; }),
      "material.clay.su_residual", "the residual strength exceeds the peak strength",
      "At the point at (6.05, 0.05) m: ");
}

TEST(PointParameters, ThatTheLawKeepsUniformAreRefused)
{
  Case c = column("mpm_gp");
  c.materials[0] = {"clay", "newtonian_fluid", 1000.0, {2e6, 5.0, 0.0}, {{1, [](Vec<2>) { return 5.0; }}}};
  expect_refused(c, "material.clay.viscosity", "this parameter is the same for all points",
      "The law newtonian_fluid does not let viscosity vary from point to point. Give one number.");
}

}  // namespace point_parameters_test
