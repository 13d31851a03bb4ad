#include "import/dstability/soil_text.hpp"

#include "sections.hpp"
#include "support/problems.hpp"

namespace soil_text_test {

SoilUse use_of(const StixSoil& soil, bool above = false)
{
  return {.soil = &soil,
      .above = above,
      .name = "soil",
      .where = "",
      .stage = "high water",
      .strength_water = "",
      .preload = {"pop = \"10 kPa\"", "POP"},
      .largest_stress = 0.0};
}

SoilText text_of(const StixSoil& soil, bool above = false, StixBasis basis = StixBasis::deterministic)
{
  return soil_text(use_of(soil, above), basis, kinds());
}

std::string value_of_key(const SoilText& text, const std::string& key)
{
  return test::value_of_key(text.material.lines, key);
}

std::vector<Problem> problems_with(const StixSoil& soil, StixBasis basis = StixBasis::deterministic)
{
  return problems_of([&] { text_of(soil, false, basis); });
}

TEST(SoilText, HasTheNumbersOfDrainedSoil)
{
  const SoilText sand = text_of(two_soils()[0]);
  EXPECT_EQ(value_of_key(sand, "model"), "\"mohr_coulomb\"");
  EXPECT_EQ(value_of_key(sand, "density"), "\"20 kN/m3\"");
  EXPECT_EQ(value_of_key(sand, "friction_angle"), "26.5650512");         // tan phi* = sin 30, without dilatancy
  EXPECT_THAT(value_of_key(sand, "cohesion"), StartsWith("\"1.73205"));  // 2 cos 30
  EXPECT_THAT(
      in_english(sand.assumed), Contains("soil: phi' = 30 degrees and c' = 2 kPa of the file were reduced to 26.57 and "
                                         "1.73, as D-Stability reduces them on slip planes of soil that dilates by 0 "
                                         "degrees."));
  EXPECT_EQ(value_of_key(sand, "shear_modulus"), "\"12 MPa\"");  // default of sand
}

TEST(SoilText, HasTheNumbersOfShansepAndTheirDesignValues)
{
  const StixSoil clay = two_soils()[1];
  EXPECT_THAT(value_of_key(text_of(clay), "su_peak"), HasSubstr("S = 0.25, m = 0.8, pop = \"10 kPa\", minimum"));
  EXPECT_THAT(value_of_key(text_of(clay, false, StixBasis::design), "su_peak"), HasSubstr("S = 0.225386"));
}

TEST(SoilText, KeepsTheStrengthOfSoilThatDilatesAsMuchAsItRubs)
{
  StixSoil sand = two_soils()[0];
  sand.advanced.dilatancy.value = 30.0;
  const SoilText text = text_of(sand);
  EXPECT_EQ(value_of_key(text, "friction_angle"), "30");
  EXPECT_EQ(value_of_key(text, "cohesion"), "\"2 kPa\"");
  EXPECT_EQ(value_of_key(text, "dilatancy_angle"), "30");
  EXPECT_THAT(in_english(text.assumed), Not(Contains(HasSubstr("reduced"))));
  sand.advanced.dilatancy.value = 29.0;  // phi* = 29.997 degrees
  EXPECT_EQ(value_of_key(text_of(sand), "dilatancy_angle"), "29");
}

TEST(SoilText, TakesClassicStrengthAsItIs)
{
  const SoilText clay = text_of(two_soils()[1], true);
  EXPECT_EQ(value_of_key(clay, "friction_angle"), "25");
  EXPECT_EQ(value_of_key(clay, "cohesion"), "\"5 kPa\"");
  EXPECT_THAT(in_english(clay.assumed), Not(Contains(HasSubstr("reduced"))));
}

TEST(SoilText, RefusesEmptyNumbersWithSoilParameterAndStage)
{
  StixSoil sand = two_soils()[0];
  sand.advanced.cohesion.value = not_given;
  sand.advanced.friction.value = not_given;
  EXPECT_THAT(problems_with(sand),
      ElementsAre(told("soil `sand`", "its cohesion is empty",
                      "Allowed are 0 to 10000 kPa. It is asked for below the phreatic line in stage `high water`. "
                      "Correct it in D-Stability."),
          told("soil `sand`", "its friction angle is empty")));
  StixSoil clay = two_soils()[1];
  clay.ratio.value = not_given;
  EXPECT_THAT(problems_with(clay), ElementsAre(told("soil `clay`", "its shear strength ratio S is empty",
                                       StartsWith("Allowed are 0.001 to 2. It"))));
  clay.below = StixStrengthModel::su_table;
  EXPECT_THAT(problems_with(clay), ElementsAre(told("soil `clay`", "its SuTable has no rows")));
  clay.below = StixStrengthModel::none;
  clay.below_word = "None";
  EXPECT_THAT(
      problems_with(clay), ElementsAre(told("soil `clay`", "its strength is `None`, which Terp cannot take over")));
}

TEST(SoilText, RefusesNumbersThatNoSoilHas)
{
  StixSoil sand = two_soils()[0];
  sand.advanced = {{.value = -1e3}, {.value = 30.0}, {.value = 40.0}};
  sand.weight_below = 0.0;
  EXPECT_THAT(problems_with(sand),
      ElementsAre(told("soil `sand`", "its unit weight is 0 kN/m3", HasSubstr("Allowed are 0.1 to 100 kN/m3.")),
          told("soil `sand`", "its cohesion is -1 kPa"),
          told("soil `sand`", "its dilatancy is 40 degrees", HasSubstr("At most the friction angle, 30 degrees."))));
  sand = two_soils()[0];
  sand.advanced.friction.value = 70.0;
  EXPECT_THAT(problems_with(sand),
      ElementsAre(told("soil `sand`", "its friction angle is 70 degrees", HasSubstr("0 to 60 degrees"))));
}

TEST(SoilText, RefusesADesignValueWithoutAStandardDeviation)
{
  StixSoil clay = two_soils()[1];
  clay.ratio.deviation = not_given;
  EXPECT_THAT(problems_with(clay), ElementsAre());
  EXPECT_THAT(problems_with(clay, StixBasis::mean), ElementsAre());
  EXPECT_THAT(problems_with(clay, StixBasis::design),
      ElementsAre(told("soil `clay`", "its shear strength ratio S has no design value",
          HasSubstr("It needs a mean and a standard deviation."))));
}

TEST(SoilText, SaysThatAnEmptyDilatancyIsZero)
{
  StixSoil sand = two_soils()[0];
  sand.advanced.dilatancy.value = not_given;
  const SoilText text = text_of(sand);
  EXPECT_EQ(value_of_key(text, "dilatancy_angle"), "0");
  EXPECT_THAT(in_english(text.assumed), Contains("soil: its dilatancy is empty in the file; taken was 0."));
}

TEST(SoilText, OfADrawingIsThatOfItsKind)
{
  const CaseMaterialText klei = default_soil_text("klei", "Klei 2", kind_of_soil(kinds(), "Klei 2"));
  const auto line = std::ranges::find(klei.lines, "su_peak", &CaseLine::key);
  EXPECT_EQ(line->value, "{ shansep = { S = 0.25, m = 0.9, pop = \"22 kPa\", minimum = \"2 kPa\" } }");
}

}  // namespace soil_text_test
