#include "batch/follow.hpp"

#include "io/case/expression.hpp"
#include "batch/samples.hpp"
#include "batch/study.hpp"

namespace follow_test {

/// A strength that two keys follow, as of a soil that is two materials.
const std::string named_study = terp::test::changed(terp::test::column_study, "key = \"material.clay.su_peak\"",
                                    "name = \"strength\"\nunit = \"Pa\"") +
                                R"toml(
[follow]
"material.clay.su_peak" = "strength"
"material.clay.shear_modulus" = "100 * max(strength, 5e3)"
)toml";

TEST(Follow, KeysHaveTheValuesOfTheirFormulas)
{
  const ScratchFolder folder;
  const Study study = prepare_study(read_study(write_study(folder.path(), named_study, column_case)));
  EXPECT_THAT(study.input_names(), ElementsAre("strength"));
  for (const Index k : {0, 1, 2, 3}) {
    const Draw draw = draw_realisation(study, k);
    const Case c = case_of(study, draw).values;
    EXPECT_DOUBLE_EQ(c.materials[0].parameters[2], draw.inputs[0]) << "su_peak";
    EXPECT_DOUBLE_EQ(c.materials[0].parameters[0], 100.0 * std::max(draw.inputs[0], 5e3)) << "shear_modulus";
  }
}

TEST(Follow, ItIsTheStudyThatDrawsTheKeyItself)
{
  const ScratchFolder one, other;
  const Study named = prepare_study(read_study(write_study(one.path(),
                  changed(named_study, "\"material.clay.shear_modulus\" = \"100 * max(strength, 5e3)\"\n", ""),
                  column_case))),
              of_key = prepare_study(read_study(write_study(other.path(), column_study, column_case)));
  for (const Index k : {0, 5, 11}) EXPECT_EQ(draw_realisation(named, k).changes, draw_realisation(of_key, k).changes);
}

TEST(Follow, OnlyAWordOfItsOwnIsAName)
{
  const Node text = parse_toml("a = \"2 * S_clay\"\nb = \"S_clay_2\"\nc = [[0, \"1 + S_clay\"]]");
  EXPECT_TRUE(has_formula(text.items[0], {"S_clay"}));
  EXPECT_FALSE(has_formula(text.items[1], {"S_clay"}));
  EXPECT_EQ(toml_value(with_numbers(text.items[2], {"S_clay"}, {0.5})), "[[0, 1.5]]");
  EXPECT_EQ(toml_value(with_numbers(text.items[1], {"S_clay"}, {0.5})), "\"S_clay_2\"") << "other texts stay";
}

TEST(Follow, WithOneMistakeHasOneMessage)
{
  expect_messages(named_study,
      {
          {"name = \"strength\"", "name = \"h\"", "`h` is no name for a number in formulas"},
          {"name = \"strength\"", "name = \"sin\"", "`sin` is no name for a number in formulas"},
          {"name = \"strength\"", "name = \"my strength\"", "`my strength` is no name for a number in formulas"},
          {"\"strength\"\n\"mat", "\"9e3\"\n\"mat", "`material.clay.su_peak` follows no number"},
          {"\"strength\"\n\"mat", "\"strength *\"\n\"mat", "this is no formula of the numbers that have a name"},
          {"\"strength\"\n\"mat", "\"log(0 * strength)\"\n\"mat", "is no number at strength = "},
          {"\"strength\"\n\"mat", "\"0 - strength\"\n\"mat", "the case does not take `strength`"},
          {"[follow]\n", "[follow]\n\"material.clay.eta\" = 3\n", "`material.clay.eta` follows no number"},
          {"[follow]\n", "[folow]\n", "unknown key `folow`"},
          {"[stop]", "[held]\n\"material.clay.su_pek\" = 1\n[stop]", "the case does not take what [held] changes"},
      });
  EXPECT_THAT(message_on(named_study,
                  {"\"strength\"\n\"material.clay.shear_modulus\" = \"100 * max(strength, 5e3)\"", "8e3", ""}),
      HasSubstr("`material.clay.su_peak` follows no number"));
}

}  // namespace follow_test
