// Whole runs of a block that flies freely, where the value of each kind of quantity is known.
#include "verify/solve_variant.hpp"
#include "run/measure/followers.hpp"
#include "run/report/ledger.hpp"
#include "whole/ledger_samples.hpp"
#include <fmt/format.h>

namespace solve_variant_test {

const std::string head = R"(title = "Flight"
[constants]
V = { key = "body[0].velocity[0]" }
)";

std::string quantity(const std::string& lines) { return "[[quantity]]\nsource = \"Newton\"\n" + lines + "\n"; }

Solved solve(const std::string& quantities, const std::string& runs = "")
{
  const LedgerSample sample(head + runs + quantities);
  const Expected file = read_expected(sample.path());
  const auto solves = list_solves(file, true, true);
  return solve_variant(solves.front(), std::atomic<bool>{false});
}

/// The only finding.
Finding find(const std::string& lines)
{
  const Solved solved = solve(quantity(lines));
  EXPECT_EQ(solved.fault, "");
  EXPECT_EQ(solved.findings.size(), 1u);
  return solved.findings.empty() ? Finding{} : solved.findings.front();
}

TEST(SolveVariant, AFieldAtATimeIsHeldAgainstItsFormula)
{
  const Finding f = find(
      "name = \"path\"\nvalue = \"x-x0\"\ntime = 0.2\nreduce = \"max_error\"\nreference = \"V*t\"\ntolerance = "
      "\"1e-9*V\"");
  EXPECT_LT(f.value, 1e-12);
  EXPECT_TRUE(std::isnan(f.reference));
  EXPECT_EQ(f.tolerance, 2e-9);
  EXPECT_EQ(f.scheme, "mpm_gp");
}

TEST(SolveVariant, OnlyPointsThatAreMeantCount)
{
  const Finding f =
      find("name = \"mean\"\nvalue = \"x0\"\nwhere = \"x0 < 1\"\nreduce = \"mean\"\nreference = 0.75\ntolerance = 1");
  EXPECT_NEAR(f.value, 0.75, 1e-12);
  EXPECT_NEAR(f.reference, 0.75, 1e-12);
}

TEST(SolveVariant, APointIsFollowedFromWhereItStarted)
{
  const Finding f = find(
      "name = \"place\"\nkind = \"point\"\nat = [0.6, 0.1]\nvalue = \"x\"\ntime = 0.3\nreference = "
      "\"x0+V*t\"\ntolerance = 1e-9");
  EXPECT_NEAR(f.value, 0.625 + 0.6, 1e-9);
  EXPECT_NEAR(f.reference, 0.625 + 0.6, 1e-9);
}

TEST(SolveVariant, LedgerSummaryAndFormulasOfEarlierQuantities)
{
  const Solved solved = solve(
      quantity("name = \"p\"\nas = \"p\"\nkind = \"ledger\"\nvalue = \"momentum_x\"\ntime = \"end\"") +
      quantity("name = \"n\"\nas = \"n\"\nkind = \"summary\"\nvalue = \"points\"") +
      quantity(
          "name = \"per point\"\nkind = \"formula\"\nvalue = \"p/n\"\nreference = \"2000/16*V\"\nrelative = 1e-12"));
  ASSERT_EQ(solved.fault, "");
  ASSERT_EQ(solved.findings.size(), 1u);  // the first two have no row
  EXPECT_NEAR(solved.findings[0].value, 250.0, 1e-9);
  EXPECT_EQ(solved.findings[0].reference, 250.0);
}

TEST(SolveVariant, EveryColumnOfTheLedgerMayBeMeasured)
{
  const auto table = ledger_table(all_followers());
  for (const QuantityInfo& column : table->columns)
    if (column.name != "time") {
      const Finding f = find(
          fmt::format("name = \"n\"\nkind = \"ledger\"\nvalue = \"{}\"\ntime = \"end\"\nat_most = 1", column.name));
      EXPECT_EQ(f.fault.find("is not known"), std::string::npos) << column.name << ": " << f.fault;
    }
}

TEST(SolveVariant, WhatCannotBeMeasuredIsRefusedAtItsPlace)
{
  const std::string path = "name = \"path\"\nreference = 0\nvalue = ",
                    point =
                        "name = \"place\"\nkind = \"point\"\nvalue = \"x\"\nreference = 0\ntolerance = 1\ntime = 0.3\n",
                    mass = "name = \"mass\"\nkind = \"ledger\"\nvalue = \"mass\"\nat_least = 1\n",
                    mean = "name = \"mean\"\nvalue = \"x\"\nreduce = \"mean\"\n",
                    error = path + "\"x\"\nreduce = \"max_error\"\n";
  const std::vector<std::pair<std::string, std::vector<std::string>>> rows = {
      {mass + "time = \"end\"", {}},
      {mass + "reduce = \"arrival\"\nthreshold = 1e9", {}},  // never, but looked for
      {path + "\"ux\"\ntime = 0.25\ntolerance = 1",
          {"there is no frame at 0.25 s", "Let output.fields.every of the case divide the time."}},
      {mass + "time = 0.6", {"expected.toml:10:8: there is no row at 0.6 s", " rows, from 0 to 0.5 s."}},
      {mass + "reduce = \"max\"\nfrom = 0.4\nto = 0.2", {"expected.toml:11:8: there is no row from 0.4 to 0.2 s"}},
      {mass + "reduce = \"max\"\nfrom = 0.6", {"there is no row from 0.6 to inf s"}},
      {"name = \"push\"\nkind = \"footing\"\nvalue = \"reaction_y\"\nreduce = \"max\"\nat_least = 1",
          {"there is no footing in this case", "[[footing]]"}},
      {point + "at = [3.0, 0.1]", {"there is no soil at x = 3 m, y = 0.1 m", "Choose a place in a body at t = 0."}},
      {path + "\"uz\"\ntolerance = 1",
          {"expected.toml:8:9: this formula cannot be evaluated", "`uz` is not known here"}},
      {error + "tolerance = -0.1", {"`tolerance` must be a finite number, 0 or more"}},
      {error + "tolerance = \"1/0\"", {"Got inf."}},
      {error + "tolerance = 1\nscale = \"-V\"", {"`scale` must be a finite number, greater than 0"}},
      {mean + "reference = 1\nrelative = \"-V\"", {"`relative` must be a finite number, 0 or more"}},
      {mean + "at_least = \"sqrt(-V)\"", {"`at_least` must be a finite number\n"}},
  };
  for (const auto& [lines, words] : rows) {
    const std::string fault = find(lines).fault;
    EXPECT_EQ(fault.empty(), words.empty()) << lines << fault;
    for (const std::string& part : words) EXPECT_THAT(fault, HasSubstr(part)) << lines;
  }
}

TEST(SolveVariant, TheReferenceOfASeriesIsReducedAsTheSeriesIs)
{
  const std::string way =
      "name = \"way\"\nkind = \"point\"\nat = [0.6, 0.1]\nvalue = \"x\"\nreference = \"x0+V*t\"\ntolerance = "
      "1e-9\nreduce = ";  // frames 0, 0.1, ..., 0.5
  for (const auto& [reduce, expected] : std::vector<std::pair<std::string, Real>>{
           {"mean", 1.125}, {"max", 1.625}, {"min", 0.625}, {"sum", 6.75}, {"last", 1.625}}) {
    const Finding f = find(way + '"' + reduce + '"');
    EXPECT_EQ(f.fault, "") << reduce;
    EXPECT_NEAR(f.value, expected, 1e-9) << reduce;
    EXPECT_NEAR(f.reference, expected, 1e-9) << reduce;
  }
  EXPECT_THAT(find(way + "\"arrival\"\nthreshold = 1").fault, HasSubstr("`t` is not known here"));
}

TEST(SolveVariant, AConstantDoesNotHideWhatIsMeasured)
{
  const Solved solved = solve(quantity("name = \"p\"\nvalue = \"x\"\nas = \"y\"\nreduce = \"mean\"") +
                              quantity("name = \"q\"\nvalue = \"y\"\nreduce = \"mean\"\nat_least = 0"));
  ASSERT_EQ(solved.findings.size(), 1u);
  EXPECT_THAT(solved.findings[0].fault, HasSubstr("`y` is a constant and the name of what stands here"));
}

TEST(SolveVariant, AWrongQuantityCostsNoOther)
{
  const std::string good =
      "value = \"x-x0\"\ntime = 0.2\nreduce = \"max_error\"\nreference = \"V*t\"\ntolerance = 1e-9";
  const Solved solved =
      solve(quantity("name = \"nowhere\"\nwhere = \"x0 > 99\"\n" + good) +
            quantity("name = \"no place\"\nkind = \"point\"\nat = [3.0, 0.1]\nvalue = \"x\"\nas = \"p\"") +
            quantity("name = \"path\"\n" + good) +
            quantity("name = \"of p\"\nkind = \"formula\"\nvalue = \"2*p\"\nreference = 1\ntolerance = 1"));
  EXPECT_EQ(solved.fault, "");
  ASSERT_EQ(solved.findings.size(), 4u);
  EXPECT_THAT(solved.findings[0].fault, HasSubstr("no point is `where` this says"));
  EXPECT_THAT(solved.findings[1].fault, HasSubstr("there is no soil at x = 3 m"));
  EXPECT_EQ(solved.findings[2].fault, "");
  EXPECT_LT(solved.findings[2].value, 1e-12);
  EXPECT_THAT(solved.findings[3].fault, HasSubstr("`p` is not known here"));
}

TEST(SolveVariant, OneValueThatIsNoNumberMakesTheLargestNone)
{
  const Finding f = find("name = \"largest\"\nvalue = \"sqrt(x0-1)\"\nreduce = \"max\"\nat_least = 0");
  EXPECT_EQ(f.fault, "");
  EXPECT_TRUE(std::isnan(f.value));
  EXPECT_TRUE(std::isnan(
      find("name = \"mean\"\nvalue = \"x0\"\nwhere = \"sqrt(x0-1)\"\nreduce = \"mean\"\nat_least = 0").value));
}

TEST(SolveVariant, AKeyThatTheCaseDoesNotSetIsNoConstant)
{
  EXPECT_EQ(solve("h = 1\n").fault, "");
  const LedgerSample sample("title = \"x\"\n[constants]\na = { key = \"time.courant\" }\n");
  const Expected file = read_expected(sample.path());
  EXPECT_THAT(solve_variant(list_solves(file, true, true).front(), std::atomic<bool>{false}).fault,
      HasSubstr("the case says nothing of `time.courant`"));
}

TEST(SolveVariant, RunsAreEachVariantWithEachSchemeShortOrLong)
{
  const auto schemes = [](const char* runs, bool with_short, bool with_long) {
    const LedgerSample sample("title = \"x\"\n[[run]]\nschemes = [\"mpm_gp\", \"mpm_mixed\"]\n" + std::string(runs));
    std::vector<std::string> list;
    const Expected file = read_expected(sample.path());
    for (const Solve& solve : list_solves(file, with_short, with_long)) list.push_back(solve.scheme);
    return list;
  };
  const char *two = "name = \"a\"\n[[run]]\nname = \"b\"\nlong = true\n", *one_long = "long = [\"mpm_mixed\"]\n";
  EXPECT_THAT(schemes(two, true, true), ElementsAre("mpm_gp", "mpm_mixed", ""));
  EXPECT_THAT(schemes(two, true, false), ElementsAre("mpm_gp", "mpm_mixed"));
  EXPECT_THAT(schemes(two, false, true), ElementsAre(""));
  EXPECT_THAT(schemes(one_long, true, true), ElementsAre("mpm_gp", "mpm_mixed"));
  EXPECT_THAT(schemes(one_long, true, false), ElementsAre("mpm_gp"));
  EXPECT_THAT(schemes(one_long, false, true), ElementsAre("mpm_mixed"));
}

TEST(SolveVariant, ARunThatStopsItselfIsAFault)
{
  EXPECT_NE(solve("", "[[run]]\nset = [\"body[0].velocity=[1e9,0.0]\"]\n").fault, "");
}

}  // namespace solve_variant_test
