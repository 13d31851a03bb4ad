#include "import/dstability/case_text.hpp"
#include "io/case/printable.hpp"
#include "support/test.hpp"

namespace case_text_test {

TEST(SectionTextOf, NumbersAreShortAndExactEnough)
{
  EXPECT_EQ(number_text(2.0), "2.0");
  EXPECT_EQ(number_text(-0.0), "0.0");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(12.34999998765), "12.3499999876");
}

TEST(SectionTextOf, NamesAreKeys)
{
  EXPECT_EQ(key_of_name("Clay, shallow (1)"), "clay_shallow_1");
  EXPECT_EQ(key_of_name("--"), "soil");
  EXPECT_EQ(in_quotes("a \"b\" \\ c\n"), R"("a \"b\" \\ c ")");
}

TEST(SectionTextOf, SignsOfNumbersStayInKeys)
{
  EXPECT_EQ(key_of_name("river at -2.00 m"), "river_at_minus_2_00_m");
  EXPECT_EQ(key_of_name("river at +2.00 m"), "river_at_plus_2_00_m");
  EXPECT_EQ(key_of_name("river at 2.00 m"), "river_at_2_00_m");
  EXPECT_EQ(key_of_name("NAP-0,40"), "nap_minus_0_40");
  EXPECT_EQ(key_of_name("-3"), "minus_3");
  EXPECT_EQ(key_of_name("−3 (–4)"), "minus_3_minus_4");  // the minus of print, and a dash
  EXPECT_EQ(key_of_name("Clay L1-2, 2020-2021 - 3"), "clay_l1_2_2020_2021_3");
}

TEST(SectionTextOf, OddNamesAreKeys)
{
  EXPECT_EQ(key_of_name("Veen, geïnundeerd; één ß"), "veen_geinundeerd_een_ss");
  EXPECT_EQ(key_of_name("γ = 3 砂"), "3");
  EXPECT_EQ(key_of_name("砂", "stage"), "stage");
  EXPECT_EQ(key_of_name("\xFF\xC3", "layer"), "layer");
  EXPECT_EQ(key_of_name("", "load"), "load");
}

TEST(SectionTextOf, BodiesHaveNamesOfTheirOwnThatAreNoNumbers)
{
  std::vector<CaseBodyText> bodies(4);
  bodies[0].name = bodies[2].name = "clay";
  bodies[1].name = "7";
  bodies[3].name = "clay (2)";
  name_bodies(bodies);
  EXPECT_EQ(bodies[0].name, "clay");
  EXPECT_EQ(bodies[1].name, "layer 7");
  EXPECT_EQ(bodies[2].name, "clay (2)");
  EXPECT_EQ(bodies[3].name, "clay (2) (2)");
}

TEST(SectionTextOf, PlacesBreakBeforeTheMargin)
{
  std::vector<Vec<2>> places;
  for (int k = 0; k < 40; ++k) places.push_back({0.125 * k, 1.5});
  std::istringstream lines("polygon  = " + places_text(places, 2, 11));
  int n = 0;
  for (std::string line; std::getline(lines, line); ++n) EXPECT_LE(line.size(), 120u);
  EXPECT_EQ(n, 5);
  EXPECT_EQ(places_text({{1, 2}, {3, 4}}, 2, 11), "[[1.0, 2.0], [3.0, 4.0]]");
}

TEST(SectionTextOf, CommentsStandBesideTheirValuesOrAboveThem)
{
  SectionText text;
  text.title = "t";
  text.after.push_back(
      {"[forces]", "why", {{"gravity", "[0.0, -9.81]", "m/s2"}, {"long", std::string(50, '1'), "above"}}});
  const std::string toml = text_of(text);
  EXPECT_THAT(
      toml, HasSubstr("# why\n[forces]\ngravity = [0.0, -9.81]                   # m/s2\n# above\nlong    = 1111"));
}

TEST(CaseText, HasNoControlCharactersAndOnlyUtf8)
{
  SectionText text;
  text.title = "a\x01 \xEF";
  text.head = {"code a\rb\x1B[31m \xEFlayer"};
  EXPECT_THAT(text_of(text), AllOf(StartsWith("# code a?b?[31m ?layer\n"), HasSubstr("title  = \"a  \xEF\xBF\xBD\"")));
}

TEST(CaseText, WrapsBetweenLettersAndLosesNone)
{
  std::string name = "x";
  for (int k = 0; k < 150; ++k) name += "\xC3\xA9";  // two bytes each: a cut at a fixed byte would part one
  SectionText text;
  text.head = {name};
  std::string toml = text_of(text), together;
  for (std::istringstream lines(toml.substr(0, toml.find("\ntitle"))); std::getline(lines, toml);) {
    EXPECT_EQ(printable(toml), toml);
    together += toml.substr(2);
  }
  EXPECT_EQ(together, name);
}

}  // namespace case_text_test
