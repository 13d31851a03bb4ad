#include "model/parts/reduce.hpp"
#include "soil/laws/material.hpp"
#include "support/cases.hpp"

namespace reduce_test {

constexpr Real degree = std::numbers::pi / 180.0;

std::vector<std::string> keys(const Case& c)
{
  std::vector<std::string> names;
  for (const Strength& s : strengths_of(c)) names.push_back(s.key);
  return names;
}

/// A law's parameters by name, others at their default.
Real parameter(const MaterialCase& material, std::string_view name)
{
  const auto parameters = find_material(material.model)->parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (parameters[k].name == name) return material.parameters[k];
  return std::nan("");
}

TEST(Reduce, ClayHasPeakAndResidualStrengthAndItsBaseAdhesion)  // what it does not have is not named
{
  const Case c = column("mpm_gp");
  EXPECT_THAT(keys(c), ElementsAre("material.clay.su_peak", "material.clay.su_residual", "boundary.bottom.adhesion"));
}

TEST(Reduce, AMaterialThatNoBodyHasIsNoStrengthOfTheCase)
{
  Case c = column("mpm_gp");
  c.sides.clear();
  c.materials.push_back(c.materials[0]);
  c.materials[1].name = "other";
  EXPECT_EQ(keys(c).size(), 2u);
  c.materials = {elastic(1e6, 0.3, 2000.0)};
  c.bodies[0].material = c.materials[0].name;
  EXPECT_THAT(keys(c), IsEmpty());
}

TEST(Reduce, DividesStressesAndLeavesTheRest)
{
  const Case c = column("mpm_gp"), reduced = reduce_strength(c, 1.6);
  EXPECT_DOUBLE_EQ(parameter(reduced.materials[0], "su_peak"), 8000.0 / 1.6);
  EXPECT_DOUBLE_EQ(parameter(reduced.materials[0], "su_residual"), 2000.0 / 1.6);
  EXPECT_EQ(parameter(reduced.materials[0], "shear_modulus"), 2.0e6);
  EXPECT_EQ(parameter(reduced.materials[0], "eta"), 50.0);
  EXPECT_DOUBLE_EQ(reduced.sides.back().adhesion, c.sides.back().adhesion / 1.6);
}

TEST(Reduce, DividesAStrengthThatVariesAtEachPlace)
{
  Case c = column("mpm_gp");
  c.materials[0].fields = {{2, [](Vec<2> x) { return 8e3 + 100.0 * x[1]; }}};
  EXPECT_DOUBLE_EQ(reduce_strength(c, 1.6).materials[0].fields[0].value_at({0.0, 4.0}), 8400.0 / 1.6);
  const auto strengths = strengths_of(c);
  EXPECT_TRUE(std::isnan(strengths.at(0).value)) << "one number would say too much";
  EXPECT_EQ(strengths.at(1).value, 2e3);
}

TEST(Reduce, LeavesAStiffnessThatFollowsFromAStrengthAsItIs)
{
  Case c = column("mpm_gp");
  const FieldValue strength = [](const PlaceInSoil& at) { return 8e3 + 100.0 * at.x[1]; };
  c.materials[0].fields = {{0, [strength](const PlaceInSoil& at) { return 100.0 * strength(at); }}, {2, strength}};
  const Case reduced = reduce_strength(c, 1.6);
  EXPECT_DOUBLE_EQ(reduced.materials[0].fields[0].value_at({{0.0, 4.0}}), 840e3);
  EXPECT_DOUBLE_EQ(reduced.materials[0].fields[1].value_at({{0.0, 4.0}}), 5250.0);
}

TEST(Reduce, DividesTheTangentsOfAngles)
{
  Case c = column("mpm_gp");
  MaterialCase& sand = c.materials[0];
  sand.model = "mohr_coulomb";
  sand.parameters.clear();
  for (const ParameterInfo& p : find_material("mohr_coulomb")->parameters)
    sand.parameters.push_back(p.name == "friction_angle" || p.name == "friction_angle_residual" ? 35.0
                              : p.name == "dilatancy_angle"                                     ? 5.0
                              : p.name == "cohesion"                                            ? 3000.0
                                                     : p.fallback.value_or(1.0));
  const MaterialCase reduced = reduce_strength(c, 1.25).materials[0];
  EXPECT_NEAR(std::tan(parameter(reduced, "friction_angle") * degree), std::tan(35.0 * degree) / 1.25, 1e-14);
  EXPECT_NEAR(std::tan(parameter(reduced, "friction_angle_residual") * degree), std::tan(35.0 * degree) / 1.25, 1e-14);
  EXPECT_NEAR(std::tan(parameter(reduced, "dilatancy_angle") * degree), std::tan(5.0 * degree) / 1.25, 1e-14);
  EXPECT_DOUBLE_EQ(parameter(reduced, "cohesion"), 2400.0);
  EXPECT_TRUE(std::isinf(parameter(reduced, "tension_cutoff")));  // none stays none
}

TEST(Reduce, WhatOnlyFastShearingGivesIsLeftOutByItself)
{
  Case c = column("mpm_gp");
  c.materials[0].parameters =
      find_material("tresca_softening")->complete(std::vector<Real>{2e6, 0.4, 8e3, 2e3, 50.0, 400.0, 2.0, 0.1, 1e-6});
  EXPECT_THAT(keys(c), AllOf(Contains("material.clay.su_remoulded"), Not(Contains("material.clay.rate_mu"))));
  const MaterialCase reduced = reduce_strength(c, 1.25).materials[0];
  EXPECT_DOUBLE_EQ(parameter(reduced, "su_remoulded"), 320.0);
  EXPECT_EQ(parameter(reduced, "rate_mu"), 0.1);
  const MaterialCase slow = leave_out_rate(c).materials[0];
  EXPECT_EQ(parameter(slow, "rate_mu"), 0.0);
  EXPECT_EQ(parameter(slow, "su_remoulded"), 400.0);
  EXPECT_EQ(parameter(slow, "rate_ref"), 1e-6);
}

/// The clay of the column with a limit of tension [Pa] that leave_out_tension() may take away.
Real cutoff_left(Real cutoff, const std::vector<ParameterField>& fields = {}, Vec<2> at = {0.0, 0.0})
{
  Case c = column("mpm_gp");
  MaterialCase& clay = c.materials[0];
  clay.parameters = find_material("tresca_softening")->complete(std::vector<Real>{2e6, 0.4, 8e3});
  const auto& names = find_material("tresca_softening")->parameters;
  const auto k =
      static_cast<std::size_t>(std::ranges::find(names, tension_cutoff, &ParameterInfo::name) - names.begin());
  clay.parameters[k] = cutoff, clay.fields = fields;
  const MaterialCase cracked = leave_out_tension(c).materials[0];
  const auto field = std::ranges::find(cracked.fields, k, &ParameterField::parameter);
  return field == cracked.fields.end() ? cracked.parameters[k] : field->value_at({at});
}

TEST(Reduce, ALimitOfTensionThatCannotActIsAsNotGiven)
{
  EXPECT_EQ(cutoff_left(std::numeric_limits<Real>::infinity()), 0.0);
  EXPECT_EQ(cutoff_left(1e9), 0.0);
  EXPECT_EQ(cutoff_left(16.1e3), 0.0) << "twice S_u is 16 kPa";
  EXPECT_EQ(cutoff_left(5e3), 5e3);
  const FieldValue strength = [](const PlaceInSoil& x) { return 8e3 + 1e3 * x.x[1]; };
  EXPECT_EQ(cutoff_left(20e3, {{2, strength}}, {0.0, 1.0}), 0.0) << "place by place: 2 times 9 kPa";
  EXPECT_EQ(cutoff_left(20e3, {{2, strength}}, {0.0, 3.0}), 20e3) << "2 times 11 kPa";
}

TEST(Reduce, KnowsTheLargestTensionOfSoilWithFriction)
{
  const MaterialType& sand = *find_material("mohr_coulomb");
  const auto largest = [&](Real phi) {
    return largest_tension(sand, sand.complete(std::vector<Real>{1e7, 0.3, 3e3, phi}));
  };
  EXPECT_NEAR(largest(30.0), 3e3 / std::tan(30.0 * degree), 1e-9);
  EXPECT_EQ(largest(0.0), 6e3);
}

TEST(Reduce, SaysWhatALawCannotTake)
{
  Case c = column("mpm_gp");
  EXPECT_THAT(check_reduced(c), IsEmpty());
  const auto faults = check_reduced(reduce_strength(c, 0.05));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0],
      StartsWith(
          "material.clay: softening is too steep: eta (su_peak - su_residual) = 6e+06 Pa, at most 1.5 G = 3e+06 Pa"));
}

TEST(Stiffen, MultipliesStiffnessAndSofteningPerStrainAndLeavesStrength)
{
  Case c = column("mpm_gp");
  c.forces.viscous_damping = 0.3;
  const Case stiff = stiffen(c, 100.0);
  const auto parameters = find_material(c.materials[0].model)->parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const bool per_strain = parameters[k].name == "shear_modulus" || parameters[k].name == "eta";
    EXPECT_DOUBLE_EQ(stiff.materials[0].parameters[k], c.materials[0].parameters[k] * (per_strain ? 100.0 : 1.0))
        << parameters[k].name;
  }
  EXPECT_DOUBLE_EQ(stiff.forces.viscous_damping, 3.0);  // times are ten times shorter
  EXPECT_DOUBLE_EQ(stiff.time.end, c.time.end / 10.0);
  EXPECT_EQ(stiff.sides.back().adhesion, c.sides.back().adhesion);
}

TEST(Stiffen, ScalesAViscosityByTheRoot)
{
  Case c = column("mpm_gp");
  c.materials[0] = {"clay", "newtonian_fluid", 1000.0, {2e6, 5.0, 0.0}};
  EXPECT_EQ(stiffen(c, 100.0).materials[0].parameters, (std::vector<Real>{2e8, 50.0, 0.0}));
}

TEST(Stiffen, ScalesAParameterThatVariesAtEachPlace)
{
  Case c = column("mpm_gp");
  c.materials[0].fields = {{0, [](Vec<2> x) { return 1e6 * (1.0 + x[0]); }}};
  EXPECT_DOUBLE_EQ(stiffen(c, 100.0).materials[0].fields[0].value_at({2.0, 0.0}), 3e8);
}

}  // namespace reduce_test
