#include "cli/strength_levers.hpp"
#include "soil/laws/material.hpp"
#include "support/test.hpp"
#include <fmt/format.h>

namespace strength_levers_test {

/// Changes of a lever of that name, by its smaller factor or its greater.
ScaledStrength scaled(
    const std::string& name, const std::string& toml, Real StrengthLever::*factor = &StrengthLever::less)
{
  const auto& levers = strength_levers();
  const auto lever = std::ranges::find(levers, name, &StrengthLever::name);
  return scale_strength(parse_toml(toml), *lever, (*lever).*factor);
}

TEST(StrengthLevers, ScaleEveryFormOfAStrengthAsAWhole)
{
  const auto su = [](const std::string& value) {
    const auto changes = scaled("S_u", "[material.clay]\nsu_peak = " + value + "\n").changes;
    return changes.size() == 1 ? changes[0] : fmt::format("{} changes", changes.size());
  };
  EXPECT_EQ(su("20e3"), "material.clay.su_peak=17000.0");
  EXPECT_EQ(su("\"20 kPa\""), "material.clay.su_peak=\"17 kPa\"");
  EXPECT_EQ(su("\"10e3 + 1e3*(0 - y)\""), "material.clay.su_peak=\"0.85*(10e3 + 1e3*(0 - y))\"");
  for (const char* line : {"depth", "elevation", "table"})
    EXPECT_EQ(su(fmt::format("{{ {} = [[0, 10e3], [4, \"20 kPa\"]] }}", line)),
        fmt::format("material.clay.su_peak={{{} = [[0, 8500.0], [4, \"17 kPa\"]]}}", line));
  EXPECT_THAT(
      su("{ random = { mean = 20e3, cov = 0.2 } }"), AllOf(HasSubstr("mean = 17000.0"), HasSubstr("cov = 0.2")));
  EXPECT_EQ(su("{ shansep = { S = 0.3, m = 0.9, pop = 15e3 } }"), "0 changes");  // S and POP are levers
}

TEST(StrengthLevers, FindSoilsOfTwoPartsOtherLawsSidesAndStages)
{
  EXPECT_THAT(scaled("S_u", "[material.clay]\nbelow = { su_peak = 20e3 }\nabove = { cohesion = 1e3 }\n").changes,
      ElementsAre("material.clay.below.su_peak=17000.0"));
  EXPECT_THAT(
      scaled("S_u", "[material.clay]\nsu_active = 20e3\n").changes, ElementsAre("material.clay.su_active=17000.0"));
  EXPECT_THAT(scaled("yield stress", "[material.clay]\nyield_stress = \"50 kPa\"\n").changes,
      ElementsAre("material.clay.yield_stress=\"40 kPa\""));
  EXPECT_THAT(scaled("OCR", "[material.clay]\nyield_stress = { ocr = 3.0 }\n").changes,
      ElementsAre(AllOf(HasSubstr("ocr = 2.4"), StartsWith("material.clay.yield_stress="))));
  const std::string shansep = "[material.clay]\nsu_peak = { shansep = { S = 0.3, m = 0.95, pop = 15e3 } }\n";
  EXPECT_THAT(scaled("m", shansep).changes, ElementsAre(HasSubstr("m = 0.855")));
  EXPECT_THAT(scaled("m", shansep, &StrengthLever::more).changes, ElementsAre(HasSubstr("m = 1.0,")));
  EXPECT_THAT(
      scaled("cohesion", "[material.clay]\ncohesion = 5e3\n").changes, ElementsAre("material.clay.cohesion=4000.0"));
  EXPECT_THAT(scaled("strength of sides", "[boundary]\nleft = { friction = 0.5 }\nright = \"roller\"\n").changes,
      ElementsAre("boundary.left.friction=0.4"));
  const ScaledStrength stage = scaled("S",
      "[[stage]]\nname = \"a\"\n[[stage]]\nset = { \"material.clay.su_peak.shansep.S\" = 0.4, \"forces.damping.local\" "
      "= "
      "0.1 }\n");
  ASSERT_EQ(stage.changes.size(), 1u);
  EXPECT_THAT(
      stage.changes[0], AllOf(StartsWith("stage[1].set="), HasSubstr("\"material.clay.su_peak.shansep.S\" = 0.34"),
                            HasSubstr("\"forces.damping.local\" = 0.1")));
  EXPECT_THAT(scaled("S_u", "[[stage]]\nset = { \"material.clay.su_peak.depth\" = [[0, 10e3]] }\n").changes,
      ElementsAre(HasSubstr("8500")));
}

TEST(StrengthLevers, NameWhatTheyCannotScale)
{
  const ScaledStrength csv = scaled("S_u", "[material.clay]\nsu_peak = { csv = \"su.csv\" }\n");
  EXPECT_THAT(csv.changes, IsEmpty());
  EXPECT_THAT(csv.left, ElementsAre("material.clay.su_peak (a table in a file)"));
  EXPECT_THAT(strengths_without_lever(parse_toml("[material.clay]\nmodel = \"library\"\n")),
      ElementsAre("material.clay (the law of a library)"));
  EXPECT_THAT(
      strengths_without_lever(parse_toml("[material.clay]\nmodel = \"mohr_coulomb\"\ncohesion = 1.0\n")), IsEmpty());
}

TEST(StrengthLevers, KnowTheStrengthsOfAllLaws)
{
  for (const MaterialType* law : all_materials())
    for (const ParameterInfo& p : law->parameters)
      if (is_strength(p.reduction)) {
        const std::string text = fmt::format("[material.clay]\nmodel = \"{}\"\n{} = 1.0\n", law->name, p.name);
        EXPECT_THAT(strengths_without_lever(parse_toml(text)), IsEmpty()) << law->name << ' ' << p.name;
      }
}

}  // namespace strength_levers_test
