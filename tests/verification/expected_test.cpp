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
  EXPECT_THAT(seen_with("tolerance = 1e-9\n", ""),
      HasSubstr("one of `tolerance`, `relative`, `at_least`, `at_most` must be given\n"));
  EXPECT_THAT(seen_with("tolerance = 1e-9\n", "tolerance = 1\nat_most = 2\n"), HasSubstr("Got 2."));
  EXPECT_THAT(
      seen_with("tolerance = 1e-9\n", "relative = 1e-9\n"), HasSubstr("an error takes `tolerance`, not `relative`"));
}

TEST(Expected, ANamedRunMustBeThere)
{
  EXPECT_THAT(seen_with("runs = [\"a\"]", "runs = [\"c\"]"), HasSubstr("there is no run `c`"));
  EXPECT_THAT(seen_with("runs = [\"a\"]", "red = \"slow\"\nred_runs = [\"c\"]"), HasSubstr("There are: a, b"));
  EXPECT_THAT(seen_with("value = \"ux\"\nreduce = \"max_error\"", "kind = \"order\"\nof = \"way\"\nover = \"h\""),
      HasSubstr("there is no quantity `way`"));
}

TEST(Expected, WrongTypesAreNamed)
{
  EXPECT_THAT(seen_with("long = true", "long = 1"), HasSubstr("`long` must be true or false\n"));
  EXPECT_THAT(
      seen_with("value = \"ux\"", "value = true"), HasSubstr("`value` must be a number, or a formula in quotes"));
  EXPECT_THAT(seen_with("runs = [\"a\"]", "runs = \"a\""), HasSubstr("`runs` must be a list of texts"));
  EXPECT_THAT(seen_with("title = \"Flight\"", "title = "), HasSubstr("this is not valid TOML"));
}

TEST(Expected, RunsHaveNamesOfTheirOwn)
{
  EXPECT_THAT(
      seen_with("name = \"b\"", "name = \"a\""), testing::AllOf(HasSubstr("expected.toml:10:1: there are two runs `a`"),
                                                     HasSubstr("the rows are told apart by it")));
  std::string nameless = good;
  for (const std::string name : {"name = \"a\"\n", "name = \"b\"\n", "runs = [\"a\"]\n"})
    nameless.erase(nameless.find(name), name.size());
  const test::LedgerSample sample(nameless);
  EXPECT_THROW(
      try { read_expected(sample.path()); } catch (const CaseError& error) {
        EXPECT_THAT(error.what(), HasSubstr("more than one run has no `name`"));
        throw;
      },
      CaseError);
}

TEST(Expected, QuantitiesOfOneRunHaveNamesOfTheirOwn)
{
  const std::string end = "source = \"Newton\"\n";
  const auto another = [&](const std::string& runs) {
    return end +
           "[[quantity]]\nname = \"path\"\nvalue = \"uy\"\nreduce = \"max_error\"\nreference = 0\ntolerance = 1\n" +
           runs + end;
  };
  const std::string order =
      "[[quantity]]\nname = \"rate\"\nkind = \"order\"\nof = \"path\"\nover = \"V\"\nat_least = 1\n" + end;
  EXPECT_THAT(seen_with(end, another("")),
      testing::AllOf(
          HasSubstr("expected.toml:21:1: there are two quantities `path` of one run"), HasSubstr("a name of its own")));
  EXPECT_THAT(
      seen_with(end, another("runs = [\"b\", \"a\"]\n")), HasSubstr("there are two quantities `path` of one run"));
  EXPECT_EQ(seen_with(end, another("runs = [\"b\"]\n")), "accepted");
  EXPECT_THAT(seen_with(end, another("runs = [\"b\"]\n") + order),
      HasSubstr("there are two quantities `path`, and an `of` names it"));
}

TEST(Expected, WhatTooFewRunsCannotTellIsRefused)
{
  const auto compared = [](const std::string& kind, const std::string& runs) {
    const std::string source = "source = \"Newton\"\n", rate = "[[quantity]]\nname = \"rate\"\nkind = \"" + kind +
                                                               "\"\nof = \"path\"\nover = \"V\"\nat_least = 1\n";
    return seen_with("runs = [\"a\"]\n" + source, source + rate + runs + source);
  };
  EXPECT_EQ(compared("order", ""), "accepted");
  EXPECT_THAT(compared("order", "runs = [\"a\"]\n"),
      testing::AllOf(
          HasSubstr("expected.toml:20:1: `rate` needs 2 runs of one scheme"), HasSubstr("`path` is measured in 1.")));
  EXPECT_THAT(compared("order", "differences = true\n"), HasSubstr("`rate` needs 3 runs of one scheme"));
  EXPECT_THAT(compared("extrapolated", ""),
      testing::AllOf(HasSubstr("`rate` needs 3 runs of one scheme"), HasSubstr("`path` is measured in 2.")));
  EXPECT_THAT(compared("mesh_error", ""), HasSubstr("`rate` needs 3 runs of one scheme"));
}

TEST(Expected, WhatComparesRunsIsOfWhatEachRunMeasures)
{
  const std::string end = "source = \"Newton\"\n",
                    order =
                        "[[quantity]]\nname = \"rate\"\nkind = \"order\"\nof = \"rate\"\nover = \"V\"\nat_least = 1\n" +
                        end;
  EXPECT_THAT(
      seen_with(end, end + order), HasSubstr("expected.toml:21:1: `of` names `rate`, which compares runs itself"));
}

TEST(Expected, AWordOfFormulasHasOneMeaning)
{
  EXPECT_THAT(seen_with("twice =", "dt ="), HasSubstr("expected.toml:4:1: `dt` has a meaning of its own in formulas"));
  EXPECT_THAT(seen_with("twice =", "\"a b\" ="), HasSubstr("`a b` is no name for a formula"));
  EXPECT_THAT(seen_with("twice =", "2x ="), HasSubstr("`2x` is no name for a formula"));
  const std::string end = "source = \"Newton\"\n", path = "value = \"ux\"\n";
  EXPECT_EQ(seen_with(path, path + "as = \"p\"\n"), "accepted");
  EXPECT_THAT(seen_with(path, path + "as = \"pi\"\n"), HasSubstr("expected.toml:16:6: `pi` has a meaning of its own"));
  EXPECT_THAT(seen_with(path, path + "as = \"twice\"\n"), HasSubstr("as = \"twice\" is a constant already"));
  const std::string another = "[[quantity]]\nname = \"n\"\nkind = \"summary\"\nvalue = \"n_points\"\nas = \"p\"\n";
  EXPECT_THAT(seen_with("[[quantity]]\n", another + another + "[[quantity]]\n"),
      HasSubstr("there are two quantities `n` of one run"));
  std::string renamed = another;
  renamed.replace(renamed.find("\"n\""), 3, "\"m\"");
  EXPECT_THAT(seen_with("[[quantity]]\n", another + renamed + "[[quantity]]\n"),
      HasSubstr("there are two quantities with as = \"p\" in one run"));
}

TEST(Expected, TheSearchForAFactorHasTheBoundsOfTheCommand)
{
  const auto with = [](const std::string& bounds) {
    return seen_with("seconds = 3", "seconds = 3\nstability = " + bounds);
  };
  EXPECT_EQ(with("[0.8, 1.2, 0.02]"), "accepted");
  for (const std::string bounds : {"[0.8, 1.2, -1]", "[0.8, 1.2, 0]", "[1.2, 0.8, 0.02]", "[0, 1.2, 0.02]",
           "[0.8, 1.2, nan]", "[0.8, 101, 0.02]", "[0.8, 1.2]"})
    EXPECT_THAT(with(bounds), HasSubstr("`stability` must be [from, to, tolerance] of the factor")) << bounds;
}

TEST(Expected, NamesAndTimesAreOfUse)
{
  EXPECT_THAT(seen_with("seconds = 3", "seconds = -5"), HasSubstr("`seconds` must be a number of seconds, 0 or more"));
  EXPECT_THAT(seen_with("seconds = 3", "seconds = \"five\""), HasSubstr("`seconds` must be a number of seconds"));
  EXPECT_THAT(seen_with("name = \"b\"", "name = \"b\\u001b[2J\""),
      HasSubstr("`name` must be one line of text without control characters"));
  EXPECT_THAT(seen_with("name = \"path\"", "name = \"pa\\nth\""),
      HasSubstr("`name` must be one line of text without control characters"));
}

TEST(Expected, ASchemeTwiceIsRefused)
{
  EXPECT_THAT(
      seen_with("\"mpm_mixed\"]", "\"mpm_gp\"]"), HasSubstr("expected.toml:7:22: `mpm_gp` is in `schemes` already"));
}

TEST(Expected, AKeyThatTheQuantityDoesNotLookAtIsRefused)
{
  const std::string point = "value = \"ux\"\nkind = \"point\"\nat = [1, 1]\n";
  EXPECT_EQ(seen_with("value = \"ux\"\n", point), "accepted");
  EXPECT_THAT(seen_with("value = \"ux\"\n", point + "where = \"x > 1\"\n"),
      testing::AllOf(HasSubstr("expected.toml:18:1: `where` has no effect on a quantity of kind `point` here"),
          HasSubstr("It is for the points of a field.")));
  EXPECT_THAT(seen_with("value = \"ux\"\n", "value = \"ux\"\nat = [1, 1]\n"),
      HasSubstr("`at` has no effect on a quantity of kind `field`"));
  EXPECT_THAT(seen_with("value = \"ux\"\n", point + "time = \"end\"\n"),
      HasSubstr("It is for a field, and for a series with reduce = \"at\"."));
  for (const std::string key : {"from = 1\n", "to = 1\n", "threshold = 1\n", "of = \"path\"\n", "over = \"V\"\n",
           "differences = true\n", "red_runs = [\"a\"]\n"})
    EXPECT_THAT(seen_with("value = \"ux\"\n", "value = \"ux\"\n" + key),
        HasSubstr("has no effect on a quantity of kind `field` here"))
        << key;
  EXPECT_THAT(seen_with("reduce = \"max_error\"", "reduce = \"mean\"\nscale = 2"),
      HasSubstr("It is for reduce = \"rms_error\" or \"max_error\"."));
  EXPECT_THAT(seen_with("reduce = \"max_error\"", "reduce = \"max\"\nkind = \"summary\""),
      HasSubstr("the other kinds are one number already"));
  EXPECT_THAT(seen_with("reduce = \"max_error\"", "reduce = \"last\""), HasSubstr("a field has no `last`"));
}

TEST(Expected, AFolderWithoutOneIsNoCase)
{
  try {
    read_expected("/nowhere/expected.toml");
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_STREQ(error.what(),
        "error: /nowhere/expected.toml: the file cannot be read\n  A verification case is a folder with case.toml and "
        "expected.toml.\n");
  }
}

}  // namespace
}  // namespace terp
