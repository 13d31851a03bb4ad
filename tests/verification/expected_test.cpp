#include "verification/expected.hpp"

#include "input/case_file.hpp"
#include "verification/ledger_samples.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string good = R"(title = "Flight"
[constants]
V = { key = "body[0].velocity[0]" }
twice = "2*V"
[[run]]
name = "a"
schemes = ["mpm_gp", "mpm_mixed"]
set = ["time.end=0.2"]
seconds = 3
[[run]]
name = "b"
long = true
[[quantity]]
name = "path"
value = "ux"
reduce = "max_error"
reference = "V*t"
tolerance = 1e-9
runs = ["a"]
source = "Newton"
)";

/// The message for the text with one part replaced; "accepted" if there is none.
std::string seen_with(const std::string& part, const std::string& by)
{
  std::string text = good;
  text.replace(text.find(part), part.size(), by);
  const test::LedgerSample sample(text);
  try {
    read_expected(sample.path());
  } catch (const CaseError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Expected, KeepsWhatTheFileSays)
{
  const test::LedgerSample sample(good);
  const Expected file = read_expected(sample.path());
  EXPECT_EQ(file.title, "Flight");
  ASSERT_EQ(file.constants.size(), 2u);
  EXPECT_EQ(file.constants[0].key, "body[0].velocity[0]");
  EXPECT_EQ(file.constants[1].formula.text, "2*V");
  ASSERT_EQ(file.variants.size(), 2u);
  EXPECT_THAT(file.variants[0].schemes, ElementsAre("mpm_gp", "mpm_mixed"));
  EXPECT_THAT(file.variants[0].set, ElementsAre("time.end=0.2"));
  EXPECT_EQ(file.variants[0].case_file, "case.toml");
  EXPECT_EQ(file.variants[0].seconds, 3.0);
  EXPECT_TRUE(file.variants[1].is_long);
  ASSERT_EQ(file.quantities.size(), 1u);
  EXPECT_EQ(file.quantities[0].reduce, Reduce::max_error);
  EXPECT_EQ(file.quantities[0].tolerance.text, "1e-09");
}

TEST(Expected, RefusesWhatItDoesNotKnowWithThePlaceAndTheNearestName)
{
  const std::string seen = seen_with("tolerance", "tolerence");
  EXPECT_THAT(seen, HasSubstr("expected.toml:18:1: `tolerence` is not known here"));
  EXPECT_THAT(seen, HasSubstr("Did you mean `tolerance`?"));
  EXPECT_THAT(seen_with("\"max_error\"", "\"max_eror\""), HasSubstr("Did you mean `max_error`?"));
  EXPECT_THAT(seen_with("[[run]]\nname = \"b\"", "[[run]]\nnam = \"b\""), HasSubstr("`nam` is not known here"));
}

TEST(Expected, AQuantityNeedsASourceAReferenceAndOneWayToBeJudged)
{
  EXPECT_THAT(seen_with("source = \"Newton\"", ""), HasSubstr("`source` is missing"));
  EXPECT_THAT(seen_with("reference = \"V*t\"\n", ""), HasSubstr("`reference` is missing"));
  EXPECT_THAT(seen_with("tolerance = 1e-9\n", ""), HasSubstr("one of `tolerance`, `relative`, `at_least`, `at_most` must be given\n"));
  EXPECT_THAT(seen_with("tolerance = 1e-9\n", "tolerance = 1\nat_most = 2\n"), HasSubstr("Got 2."));
  EXPECT_THAT(seen_with("tolerance = 1e-9\n", "relative = 1e-9\n"), HasSubstr("an error takes `tolerance`, not `relative`"));
}

TEST(Expected, ANamedRunMustBeThere)
{
  EXPECT_THAT(seen_with("runs = [\"a\"]", "runs = [\"c\"]"), HasSubstr("there is no run `c`"));
  EXPECT_THAT(seen_with("runs = [\"a\"]", "red_runs = [\"c\"]"), HasSubstr("There are: a, b"));
  EXPECT_THAT(seen_with("value = \"ux\"", "kind = \"order\"\nof = \"way\"\nover = \"h\""), HasSubstr("there is no quantity `way`"));
}

TEST(Expected, WrongTypesAreNamed)
{
  EXPECT_THAT(seen_with("long = true", "long = 1"), HasSubstr("`long` must be true or false\n"));
  EXPECT_THAT(seen_with("value = \"ux\"", "value = true"), HasSubstr("`value` must be a number, or a formula in quotes"));
  EXPECT_THAT(seen_with("runs = [\"a\"]", "runs = \"a\""), HasSubstr("`runs` must be a list of texts"));
  EXPECT_THAT(seen_with("title = \"Flight\"", "title = "), HasSubstr("this is not valid TOML"));
}

TEST(Expected, AFolderWithoutOneIsNoCase)
{
  try {
    read_expected("/nowhere/expected.toml");
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_STREQ(error.what(), "error: /nowhere/expected.toml: the file cannot be read\n  A verification case is a folder with case.toml and expected.toml.\n");
  }
}

}  // namespace
}  // namespace terp
