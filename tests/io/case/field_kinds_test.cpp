#include "io/case/field_kinds.hpp"
#include "io/case/case_file.hpp"
#include "io/case/case_record.hpp"
#include "io/case/samples.hpp"
#include "model/soils/overburden.hpp"
#include "support/paths.hpp"
#include "support/simulations.hpp"

namespace field_kinds_test {

/// small_case with gravity and water, and `keys` for those of the strength and the stiffness.
std::string wet(const std::string& keys)
{
  return replaced(replaced(small_case, "shear_modulus = 2.0e6\n", ""), "su_peak = 8.0e3\nsu_residual = 2.0e3\n", keys) +
         "[forces]\ngravity = [0, -9.81]\n[water]\nphreatic_line = [[0, 1.5]]\n";
}

MaterialCase material_of(const std::string& keys) { return read_case_text(wet(keys), "case.toml").values.materials[0]; }

constexpr std::size_t shear_modulus = 0, su_peak = 2, su_residual = 3, su_remoulded = 5;

TEST(FieldKinds, ATextThatIsNoNumberWithAUnitIsAFormula)
{
  const auto is = [](const char* text) {
    Node node;
    node.kind = NodeKind::text;
    node.text = text;
    return is_formula(node);
  };
  for (const char* text : {"10e3 + 1.5e3*(0 - y)", "2*x", "3 * y", "x", "-y", "(1)", "5 > x ? 1 : 2"})
    EXPECT_TRUE(is(text)) << text;
  for (const char* text : {"13 kPa", "13kPa", "8,5 kPa", "20 kN/m^3", "5 %", "3 °"}) EXPECT_FALSE(is(text)) << text;
}

TEST(FieldKinds, AFormulaIsAFieldAndANumberIsNone)
{
  const MaterialCase clay = material_of("shear_modulus = 2e6\nsu_peak = \"10e3 + 1.5e3*(0 - y) + x\"\n");
  ASSERT_EQ(clay.fields.size(), 3u) << "su_residual and su_remoulded have the value of su_peak";
  EXPECT_EQ(clay.fields[0].parameter, su_peak);
  EXPECT_DOUBLE_EQ(clay.fields[0].value_at({{2.0, 1.0}}), 8502.0);
  EXPECT_EQ(clay.fields[1].parameter, su_residual);
  EXPECT_DOUBLE_EQ(clay.fields[1].value_at({{2.0, 1.0}}), 8502.0);
  EXPECT_EQ(clay.fields[2].parameter, su_remoulded);
  EXPECT_TRUE(material_of("shear_modulus = 2e6\nsu_peak = \"13 kPa\"\n").fields.empty());
}

TEST(FieldKinds, RatiosOfNumbersAreNumbers)
{
  const MaterialCase clay = material_of("stiffness_ratio = 100\nsu_peak = \"13 kPa\"\nsensitivity = 2.5\n");
  EXPECT_TRUE(clay.fields.empty());
  EXPECT_EQ(clay.parameters[shear_modulus], 1.3e6);
  EXPECT_EQ(clay.parameters[su_residual], 5.2e3);
  EXPECT_EQ(clay.parameters[su_remoulded], 5.2e3);
}

TEST(FieldKinds, RatiosOfFieldsAreFields)
{
  const MaterialCase clay =
      material_of("stiffness_ratio = 100\nsu_peak = \"8e3+1e3*y\"\nsensitivity = { elevation = [[0, 2], [2, 4]] }\n");
  ASSERT_EQ(clay.fields.size(), 4u);
  EXPECT_DOUBLE_EQ(clay.fields[0].value_at({{0.0, 1.0}}), 9e5);
  EXPECT_DOUBLE_EQ(clay.fields[2].value_at({{0.0, 1.0}}), 3e3);
}

TEST(FieldKinds, PointsCarryWhatTheFormulaOfShansepSays)
{
  const std::string shansep = "{ S = 0.3, m = 0.9, pop = { depth = [[0, \"20 kPa\"], [2, 10e3]] } }";
  const Case c =
      read_case_text(wet("stiffness_ratio = 100\nsu_peak = { shansep = " + shansep + " }\n"), "c.toml").values;
  Model model = build_model(c, 1);
  Real mean = 0.0;
  const auto points = points_by_id(build_state(model));
  for (const Point& p : points) {
    const Real stress = 1990.0 * 9.81 * (2.0 - p.x[1]) - 9810.0 * std::max(1.5 - p.x[1], 0.0);
    const Real yield = stress + 20e3 - 5e3 * (2.0 - p.x[1]);
    ASSERT_NEAR(p.values[2], 0.3 * std::pow(stress, 0.1) * std::pow(yield, 0.9), 1e-8);
    ASSERT_NEAR(p.values[1], 100.0 * p.values[2], 1e-6) << "rows in the order of the law's table";
    mean += p.values[2] / static_cast<Real>(points.size());
  }
  EXPECT_NEAR(model.description.materials[0].parameters[su_peak], mean, 1e-6) << "the law's own value is the mean";
}

TEST(FieldKinds, FilesAreReadBesideTheCaseAndRecordedByTheirContent)
{
  const ScratchFolder scratch;
  const auto record = [&](const std::string& name, const std::string& values) {
    std::ofstream(scratch.path() + "/" + name) << "x,y,value\n" << values;
    const CaseFile file = read_case_text(
        wet("shear_modulus = 2e6\nsu_peak = { csv = \"" + name + "\" }\n"), scratch.path() + "/case.toml");
    EXPECT_DOUBLE_EQ(file.values.materials[0].fields[0].value_at({{4.0, 1.0}}), 8e3);
    EXPECT_EQ(file.inputs.size(), 1u);
    EXPECT_THAT(file.text, HasSubstr("values_1.csv"));
    return record_text(make_case_record(file, *build_model(file.values, 1).mesh));
  };
  const std::string before = record("a.csv", "0,0,7e3\n8,0,7e3\n0,2,9e3\n8,2,9e3\n");
  EXPECT_EQ(record("b.csv", "0,0,7e3\n8,0,7e3\n0,2,9e3\n8,2,9e3\n"), before);
  EXPECT_NE(record("c.csv", "0,0,7e3\n8,0,7e3\n0,2,9e3\n8,2,9e3\n9,9,9\n0,9,9\n9,0,9\n9,2,9\n8,9,9\n"), before);
}

const std::string random_su =
    "su_peak = { random = { mean = MEAN, cov = 0.2, theta = [4, 0.5], box = [[0, 0], [8, 2]], seed = 1, "
    "realisation = 3 } }\n";

TEST(FieldKinds, ARandomFieldMultipliesItsMean)
{
  const auto value = [](const std::string& mean, Vec<2> x) {
    return material_of("shear_modulus = 2e6\n" + replaced(random_su, "MEAN", mean)).fields[0].value_at({x});
  };
  const Real factor = value("1.0", {3.0, 1.0});
  EXPECT_NE(factor, 1.0);
  EXPECT_DOUBLE_EQ(value("\"20 kPa\"", {3.0, 1.0}), 20e3 * factor);
  EXPECT_DOUBLE_EQ(value("{ elevation = [[0, 10e3], [2, 6e3]] }", {3.0, 1.0}), 8e3 * factor);
  EXPECT_TRUE(std::isnan(value("1.0", {9.0, 1.0}))) << "beyond the box";
  const auto factor_of = [](const std::string& kind) {
    const std::string text =
        replaced(replaced(random_su, "MEAN", "1.0"), "seed", "correlation = \"" + kind + "\", seed");
    return material_of("shear_modulus = 2e6\n" + text).fields[0].value_at({{3.0, 1.0}});
  };
  EXPECT_EQ(factor_of("markov"), factor);
  EXPECT_NE(factor_of("matern_5_2"), factor);
}

TEST(FieldKinds, OtherParametersFollowARandomField)
{
  const MaterialCase clay =
      material_of("stiffness_ratio = 100\n" + replaced(random_su, "MEAN", "8e3") + "sensitivity = 2\n");
  const PlaceInSoil at{{3.0, 1.0}};
  ASSERT_EQ(clay.fields.size(), 4u);
  const Real su = clay.fields[1].value_at(at);
  EXPECT_DOUBLE_EQ(clay.fields[0].value_at(at), 100.0 * su);
  EXPECT_DOUBLE_EQ(clay.fields[2].value_at(at), su / 2.0);
}

TEST(FieldKinds, ARandomFieldHasTheValuesThatAreKnown)
{
  const std::string known = replaced(replaced(random_su, "MEAN", "8e3"), "seed", "known = [[3, 1, \"5 kPa\"]], seed");
  EXPECT_NEAR(material_of("shear_modulus = 2e6\n" + known).fields[0].value_at({{3.0, 1.0}}), 5e3, 1e-9);
}

}  // namespace field_kinds_test
