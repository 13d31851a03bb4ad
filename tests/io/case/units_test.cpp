// Numbers with a unit; those that are refused: wrong_cases/small_case.wrong.
#include "io/case/units.hpp"
#include "io/case/case_record.hpp"
#include "io/case/keys.hpp"
#include "io/case/samples.hpp"
#include "io/results/compare.hpp"
#include "model/meshes/setup_mesh.hpp"

namespace units_test {

Real value_of(const std::string& text, const std::string& unit_of_key)
{
  Node node;
  node.kind = NodeKind::text;
  node.text = text;
  return number_of(node, unit_of_key).value_or(std::nan(""));
}

TEST(Units, APrefixMakesTheBitsOfTheSameNumberInSi)
{
  EXPECT_EQ(value_of("13 kPa", "Pa"), 13e3);
  EXPECT_EQ(value_of("2.1 mm", "m"), 2.1e-3);
  EXPECT_NE(value_of("2.1 mm", "m"), 2.1 / 1000.0) << "rounded twice";
  EXPECT_EQ(value_of("-1.7e-3 kPa", "Pa"), -1.7);
  EXPECT_EQ(value_of("+2.5E+2 cm", "m"), 2.5);
  EXPECT_EQ(value_of("1.99 t/m3", "kg/m^3"), 1990.0);
  EXPECT_TRUE(std::isnan(value_of("1e308 kPa", "Pa")));
}

TEST(Units, OfOtherSystemsAreConverted)
{
  EXPECT_EQ(value_of("2 h", "s"), 7200.0);
  EXPECT_EQ(value_of("1.5 min", "s"), 90.0);
  EXPECT_EQ(value_of("2 d", "s"), 172800.0);
  EXPECT_DOUBLE_EQ(value_of("36 km/h", "m/s"), 10.0);
  EXPECT_DOUBLE_EQ(value_of("3.6 %/h", "1/s"), 1e-5);
  EXPECT_DOUBLE_EQ(value_of("3.141592653589793 rad", "deg"), 180.0);
  EXPECT_DOUBLE_EQ(value_of("9.81 kN/m3", "kg/m^3"), 1000.0);
  EXPECT_DOUBLE_EQ(value_of("9.81 kN/m3", "N/m^3"), 9810.0);
  EXPECT_DOUBLE_EQ(value_of("5 %", "-"), 0.05);
}

TEST(Units, AreReadAsPeopleWriteThem)
{
  for (const char* text : {"20 kN/m3", "20kN/m3", " 20  kN/m^3 ", "20 kN/m³"})
    EXPECT_DOUBLE_EQ(value_of(text, "kg/m^3"), 20e3 / 9.81) << text;
  EXPECT_EQ(value_of("30°", "deg"), 30.0);
  EXPECT_EQ(value_of("2 kPa·s", "Pa s"), 2000.0);
}

TEST(Units, ATextThatIsNoNumberWithAUnitIsNone)
{
  for (const char* text : {"", "kPa", "13", "nan kPa", "inf kPa", "-kPa", "x kPa", "0x10"})
    EXPECT_FALSE(parse_quantity(text).has_value() && parse_quantity(text)->unit != nullptr) << text;
  EXPECT_TRUE(std::isnan(value_of("13 kPa", "m")));
  EXPECT_EQ(parse_quantity("13 kips")->unit, nullptr);
}

TEST(Units, EveryUnitOfAKeyIsInTheTable)
{
  const auto check = [](const KeyInfo& key) {
    if (key.unit != "-") {
      EXPECT_THAT(units_of_key(key.unit), Not(IsEmpty())) << key.path << ": " << key.unit;
    }
  };
  for (const KeyInfo& key : all_keys()) check(key);
  for (const MaterialType* law : all_materials())
    for (const KeyInfo& key : keys_of_law(*law)) check(key);
}

TEST(Units, APathOfTheFileHasTheUnitOfItsKey)
{
  EXPECT_EQ(unit_at("material.my clay.su_peak"), "Pa");
  EXPECT_EQ(unit_at("body[0].box[1][0]"), "m");
  EXPECT_EQ(unit_at("boundary.left.adhesion"), "Pa");
  EXPECT_EQ(unit_at("output.history.points.A[0]"), "m");
  EXPECT_EQ(unit_at("nothing.of.this"), "");
}

std::string with_units()
{
  std::string text = small_case;
  text = replaced(text, "end = 4.0", "end = \"4000 ms\"");
  text = replaced(text, "size = [16.0, 3.0]", "size = [\"1600 cm\", 3.0]");
  text = replaced(text, "cell = 0.5", "cell = \"500 mm\"");
  text = replaced(text, "box = [[0.0, 0.0], [8.0, 2.0]]", "box = [[0.0, \"0 m\"], [\"8 m\", \"200 cm\"]]");
  text = replaced(text, "density = 1990.0", "density = \"1.99 t/m3\"");
  text = replaced(text, "shear_modulus = 2.0e6", "shear_modulus = \"2 MPa\"");
  return replaced(text, "su_peak = 8.0e3", "su_peak = \"8 kPa\"");
}

std::string record_of(const std::string& text, const std::vector<std::string>& changes = {})
{
  const CaseFile file = read_case_text(text, "small.toml", changes);
  return record_text(make_case_record(file, build_mesh(file.values)));
}

TEST(Units, ACaseWithUnitsIsTheSameCase)
{
  EXPECT_EQ(record_of(with_units()), record_of(small_case));
  EXPECT_THAT(case_differences(with_units(), small_case), IsEmpty());
  EXPECT_EQ(read_case_text(with_units(), "small.toml").text, with_units()) << "the record holds what was written";
}

TEST(Units, ChangesFromTheCommandLineHaveUnitsToo)
{
  EXPECT_EQ(record_of(small_case, {"material.clay.su_peak=9 kPa", "mesh.size=[\"16 m\", 3]"}),
      record_of(small_case, {"material.clay.su_peak=9e3"}));
  const CaseFile file = read_case_text(small_case, "small.toml", {"material.clay.density=19.62 kN/m3"});
  EXPECT_EQ(read_case_text(file.text, "case.toml").values.materials[0].density, file.values.materials[0].density);
  EXPECT_THAT(file.notes, ElementsAre("material.clay.density: \"19.62 kN/m3\", 2000 kg/m^3"));
}

TEST(Units, AVelocityTakesUnitsAndFormulasSideBySide)
{
  const auto body = [](const std::string& velocity) {
    return replaced(small_case, "material = \"clay\"", "material = \"clay\"\nvelocity = " + velocity);
  };
  const CaseFile file = read_case_text(body("[\"20 mm/s\", \"0.5*x\"]"), "small.toml");
  EXPECT_EQ(file.values.bodies[0].velocity_at({2.0, 0.0}), (Vec<2>{0.02, 1.0}));
  EXPECT_EQ(record_of(body("[\"20 mm/s\", \"1 cm/s\"]")), record_of(body("[0.02, 0.01]")));
  EXPECT_EQ(record_of(body("[\"20 mm/s\", \"x\"]")), record_of(body("[0.02, \"x\"]")));
}

}  // namespace units_test
