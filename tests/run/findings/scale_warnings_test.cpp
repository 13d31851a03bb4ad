#include "run/findings/setup_warnings.hpp"
#include "model/soils/soil_fields.hpp"
#include "support/simulations.hpp"

namespace scale_warnings_test {

using testing::Field;

std::vector<Problem> warnings_of(const Case& c) { return warnings_from(find_odd_scales, c); }

/// The column, 2 m high, with other clay; rho g H = 3.7e4 Pa.
std::vector<Problem> with_clay(const Clay& clay)
{
  Case c = column("mpm_gp");
  c.materials = {test::clay(clay)};
  return warnings_of(c);
}

TEST(ScaleWarnings, AreSilentOverUsualSoil)
{
  EXPECT_THAT(with_clay({}), IsEmpty());
  for (const Real su : {1e4, 1e5})
    for (const Real ratio : {20.0, 2000.0})
      EXPECT_THAT(with_clay({.shear_modulus = ratio * su, .su_peak = su, .su_residual = su}), IsEmpty()) << su;
}

/// The column with the strength of SHANSEP; its soil bears up to 37 kPa.
std::vector<Problem> with_pop(Real pop)
{
  const auto number = [](Real value) -> FieldValue { return [=](const PlaceInSoil&) { return value; }; };
  const Shansep soil{.S = number(0.23), .m = number(0.9), .pop = number(pop), .minimum = number(2e3)};
  Case c = column("mpm_gp");
  c.forces.gravity = {0.0, -9.81};
  c.materials[0].fields = {{2, by_shansep(soil)}};
  FieldNeeds& needs = c.materials[0].fields[0].needs;
  needs.outlines = needs.stress = true;
  needs.yield_stress = yield_stress_of(soil);
  return warnings_of(c);
}

TEST(ScaleWarnings, AYieldStressBeyondWhatTheSectionBearsIsDoubted)
{
  EXPECT_THAT(with_pop(15e3), IsEmpty());
  EXPECT_THAT(with_pop(30e3), IsEmpty());
  EXPECT_THAT(
      with_pop(60e3), ElementsAre(told("material.\"clay\"", "the yield stress of `clay` is far above what it bears",
                          HasSubstr("sigma'_p is on average 60 kPa above sigma'_v of daily water"))));
}

TEST(ScaleWarnings, AStrengthOffByAThousandDoesNotFitTheStiffness)
{
  const auto weak = with_clay({.su_peak = 8.0, .su_residual = 2.0});
  EXPECT_THAT(
      weak, ElementsAre(told("material.\"clay\".su_peak", "`su_peak` and the stiffness of `clay` do not fit together",
                "su_peak = 8 Pa, G = 2e+06 Pa: G / su_peak = 2.5e+05. Usual: 20 to 2000.\n"
                "Stiffness and strength are in Pa: 2 MPa is 2.0e6, 8 kPa is 8.0e3.")));
  EXPECT_THAT(with_clay({.su_peak = 8e6, .su_residual = 8e6}),
      ElementsAre(Field(&Problem::detail, HasSubstr("G / su_peak = 0.25."))));
}

TEST(ScaleWarnings, StrengthsByDirectionThatAreSwappedAreDoubted)
{
  const auto with_strengths = [](Real active, Real direct, Real passive) {
    Case c = column("mpm_gp");
    c.materials[0].model = "ngi_adp";
    c.materials[0].parameters = {3e6, 0.49, active, direct, passive, 1.0, 0.0, 0.0};
    return warnings_of(c);
  };
  EXPECT_THAT(with_strengths(14e3, 9e3, 6e3), IsEmpty());
  EXPECT_THAT(with_strengths(14e3, 16e3, 14e3), IsEmpty());
  EXPECT_THAT(with_strengths(6e3, 7e3, 14e3),
      ElementsAre(told("material.\"clay\".su_passive", "`su_passive` and `su_active` do not fit together",
          "su_passive = 1.4e+04 Pa, su_active = 6e+03 Pa: su_passive / su_active = 2.33. Usual: 0.2 to 1.2. Are "
          "they the other way round?\nStiffness and strength are in Pa: 2 MPa is 2.0e6, 8 kPa is 8.0e3.")));
  EXPECT_THAT(with_strengths(14e3, 1e3, 6e3),
      ElementsAre(Field(&Problem::what, "`su_direct` and `su_active` do not fit together")));
}

TEST(ScaleWarnings, AStiffnessOffByAThousandIsTooSoftForTheWeight)
{
  const auto soft = with_clay({.shear_modulus = 2e3, .su_peak = 400.0, .su_residual = 400.0});
  ASSERT_GE(soft.size(), 1u);
  EXPECT_THAT(soft[0], told("material.\"clay\".shear_modulus", "`clay` is too soft for its own weight",
                           HasSubstr("G = 2e+03 Pa is 0.0")));
  EXPECT_THAT(soft[0].detail, HasSubstr("times rho g H = "));
}

TEST(ScaleWarnings, StiffnessAndStrengthOffTogetherStandOutBesideTheWeight)
{
  EXPECT_THAT(with_clay({.shear_modulus = 2e9, .su_peak = 8e6, .su_residual = 8e6}),
      ElementsAre(Field(&Problem::what, "`clay` is so strong that its weight does nothing")));
  EXPECT_THAT(with_clay({.shear_modulus = 2e5, .su_peak = 80.0, .su_residual = 80.0}),
      ElementsAre(Field(&Problem::what, "`clay` is so weak that it flows like a liquid")));
}

TEST(ScaleWarnings, AnElasticStiffnessInTheWrongUnitStandsOutBesideTheWeight)
{
  Case c = column("mpm_gp");
  c.materials = {{"clay", "linear_elastic", 1900.0, {2e6, 0.3}}};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.materials[0].parameters[0] = 1e9;  // rock
  EXPECT_THAT(warnings_of(c), IsEmpty());
  const auto answer = [&](Real modulus) {
    c.materials[0].parameters[0] = modulus;
    return warnings_of(c);
  };
  const auto says = [](const char* words) {
    return ElementsAre(told("material.\"clay\".shear_modulus", words, HasSubstr("Usual: 10 to 1e4 times.")));
  };
  EXPECT_THAT(answer(2e9), says("`clay` is very stiff beside its own weight"));
  EXPECT_THAT(answer(1.5 * 1900.0 * 9.81 * 2.0), says("`clay` is very soft beside its own weight"));
  EXPECT_THAT(answer(0.5 * 1900.0 * 9.81 * 2.0), says("`clay` is too soft for its own weight"));
}

TEST(ScaleWarnings, SandWithHardlyAnyCohesionIsUsual)
{
  Case c = column("mpm_gp");
  c.materials = {{"clay", "mohr_coulomb", 1900.0, {2e7, 0.3, 10.0, 33.0, 0.0, 1e30, 10.0, 33.0, 0.0, 0.0}}};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.materials[0].parameters[3] = c.materials[0].parameters[7] = 0.0;  // without friction it is a liquid
  EXPECT_EQ(warnings_of(c).size(), 1u);
}

TEST(ScaleWarnings, SandAThousandTimesTooStiffStandsOutBesideItsFriction)
{
  Case c = column("mpm_gp");
  c.materials = {{"clay", "mohr_coulomb", 1900.0, {2e10, 0.3, 10.0, 33.0, 0.0, 1e30, 10.0, 33.0, 0.0, 0.0}}};
  EXPECT_THAT(warnings_of(c),
      ElementsAre(told("material.\"clay\".shear_modulus", "`clay` is very stiff beside its friction",
          HasSubstr("G = 2e+10 Pa is 1.74e+06 times rho g H/2 tan(phi) = 1.15e+04 Pa, its strength at mid-height"))));
}

TEST(ScaleWarnings, AVelocityInMillimetresPerSecondIsTooFast)
{
  Case c = column("mpm_gp");
  c.bodies[0].velocity = {5.0, 0.0};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.bodies[0].velocity = {5000.0, 0.0};
  const auto fast = warnings_of(c);
  EXPECT_THAT(fast, ElementsAre(told("body[0].velocity", "body 0 is very fast",
                        HasSubstr("Velocities are in m/s: 5 mm/s is 0.005."))));
  c.bodies[0].velocity = {20.0, 0.0};
  EXPECT_THAT(warnings_of(c), ElementsAre(Field(&Problem::detail, HasSubstr("20 m/s is 4.63"))));
}

TEST(ScaleWarnings, AVelocityByAFormulaIsComparedAtThePoints)
{
  Case c = column("mpm_gp");
  c.bodies[0].velocity_at = [](Vec<2> x) { return Vec<2>{0.1 * x[1], 0.0}; };
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.bodies[0].velocity_at = [](Vec<2> x) { return Vec<2>{1000.0 + 0.0 * x[1], 0.0}; };
  EXPECT_THAT(warnings_of(c), ElementsAre(told("body[0].velocity", "body 0 is very fast", HasSubstr("1000 m/s is"))));
}

TEST(ScaleWarnings, ASideIsPushedSlowly)
{
  Case c = column("mpm_gp");
  c.sides[0].kind = SideKind::velocity;
  c.sides[0].velocity = {0.01, 0.0};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.sides[0].velocity = {1.0, 0.0};
  EXPECT_THAT(warnings_of(c), ElementsAre(told("boundary.\"left\".velocity", "the side `left` is very fast",
                                  HasSubstr("usual is a hundredth or less"))));
  c.sides[0].velocity_at = [](Vec<2> x) { return Vec<2>{x[1], 0.0}; };
  EXPECT_EQ(warnings_of(c).size(), 1u);
}

TEST(ScaleWarnings, AFrictionAngleThatVariesInRadiansIsTold)
{
  Case c = column("mpm_gp");
  c.materials = {{"clay", "mohr_coulomb", 1900.0, {2e6, 0.3, 10.0, 33.0, 0.0, 1e30, 10.0, 0.0, 0.0, 0.0}}};
  for (const Real angle : {30.0, 0.52}) {
    c.materials[0].fields = {
        {.parameter = 3, .value_at = [=](const PlaceInSoil& at) { return angle + 0.01 * at.x[1]; }}};
    if (angle > 2.0)
      EXPECT_THAT(warnings_of(c), IsEmpty());
    else
      EXPECT_THAT(warnings_of(c), ElementsAre(told("material.\"clay\".friction_angle",
                                      "`friction_angle` is unusually small", HasSubstr("0.52 rad is 30 degrees"))));
  }
}

TEST(ScaleWarnings, AFootingMovesSlowlyAndFarEnough)
{
  Case c = column("mpm_gp");
  c.footings = {{.name = "plate", .low = {1.0, 2.0}, .high = {2.0, 2.5}, .velocity = {0.0, -0.01}}};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.footings[0].velocity = {0.0, -10.0};
  EXPECT_THAT(warnings_of(c),
      ElementsAre(told("footing[0].velocity", "the footing `plate` is very fast", HasSubstr("10 m/s is 2.3"))));
  c.footings[0].velocity = {0.0, -0.2};
  c.materials[0].parameters[0] = 1e5;
  EXPECT_THAT(
      warnings_of(c), Contains(Field(&Problem::what, "the footing `plate` is fast: its reaction holds inertia")));
  c.materials = {test::clay({})};
  c.footings[0].velocity = {0.0, -1e-6};
  EXPECT_THAT(warnings_of(c), ElementsAre(Field(&Problem::what, "the footing `plate` hardly moves")));
}

TEST(ScaleWarnings, ACaseInWhichNothingMovesIsTold)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  EXPECT_THAT(
      warnings_of(c), ElementsAre(Field(&Problem::what, "there is no gravity, and nothing else moves the soil")));
  Case loaded = c;
  loaded.loads = {{.name = "strip", .from = 1.1, .to = 1.9, .pressure = 1e4}};
  EXPECT_THAT(warnings_of(loaded),
      testing::Not(Contains(Field(&Problem::what, "there is no gravity, and nothing else moves the soil"))));
  c.bodies[0].velocity = {0.1, 0.0};
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

}  // namespace scale_warnings_test
