#include "verify/report.hpp"
#include "whole/ledger_samples.hpp"
#include "support/test.hpp"

namespace report_test {

std::vector<CaseRows> sample()
{
  const Row good = row_that_passes("bar");
  Row red = good, fail = good;
  red.verdict = Verdict::red, red.remark = "too coarse";
  fail.verdict = Verdict::fail;
  return {{"bar", "A bar", {good, red, fail}}};
}

TEST(Report, CountsEachKindAndSaysWhichRedIsKnown)
{
  EXPECT_EQ(counts_text(count(sample())), "3 rows: 1 pass, 2 red (1 known, with the reason) (1 not known: FAIL)");
  EXPECT_EQ(counts_text({.pass = 4, .red = 0, .fail = 0}), "4 rows: 4 pass, 0 red");
}

TEST(Report, ARowThatAgreesThoughItIsDeclaredRedIsToldAndCounted)
{
  auto pages = sample();
  pages[0].rows[0].declared_red = true;
  EXPECT_THAT(counts_text(count(pages)), HasSubstr("(1 declared red, but agree)"));
  EXPECT_THAT(text_table(pages[0]), HasSubstr("  ? stress <zz>, h = 1 m, mpm_gp: declared red in expected.toml, but "
                                              "agrees. Take `red` away, or name in `red_runs`"));
}

TEST(Report, RegressionRowsAreCountedApartAndSaid)
{
  auto pages = sample();
  Row regression = pages[0].rows[0], miss = regression;
  regression.verdict = Verdict::regression, regression.remark = "no value from outside";
  regression.declared_regression = miss.declared_regression = true;
  miss.verdict = Verdict::fail;
  pages[0].rows = {pages[0].rows[0], regression, miss};
  EXPECT_EQ(counts_text(count(pages)), "3 rows: 1 pass, 1 red, 1 regression (1 not known: FAIL)");
  EXPECT_THAT(text_table(pages[0]), AllOf(HasSubstr(" regression  "), HasSubstr(" FAIL: regression, misses  "),
                                        HasSubstr("  = regression, no pass: stress <zz>: no value from outside\n")));
  const std::string page = markdown_page(pages, "");
  EXPECT_THAT(page, HasSubstr("3 rows: 1 pass, 1 red, 1 regression (1 not known: FAIL).\n"));
  EXPECT_THAT(page, HasSubstr("| 0.2 | regression | Euler |"));
  EXPECT_THAT(page, HasSubstr("**Regression.** stress \\<zz>: no value from outside\n"));
  EXPECT_THAT(page, Not(HasSubstr("**Red.**")));
}

TEST(Report, ATenthOfTheRowsMayBeRegression)
{
  EXPECT_FALSE(too_many_regressions(0, 0));
  EXPECT_FALSE(too_many_regressions(2, 20));
  EXPECT_TRUE(too_many_regressions(2, 19));
}

TEST(Report, TheTextNamesEveryColumnAndTheReasons)
{
  const std::string text = text_table(sample()[0]);
  EXPECT_THAT(text, HasSubstr("bar: A bar\n"));
  EXPECT_THAT(text, HasSubstr("  stress <zz>  h = 1 m, mpm_gp  a|b        2     0.1    0.2        pass    Euler\n"));
  EXPECT_THAT(text, HasSubstr("  ! stress <zz>: too coarse\n"));
}

TEST(Report, MarkdownKeepsItsColumns)
{
  const std::string page = markdown_page(sample(), "How to read it.");
  EXPECT_THAT(page, HasSubstr("How to read it."));
  EXPECT_THAT(page, HasSubstr("| stress \\<zz> | h = 1 m, mpm_gp | a\\|b | 2 | 0.1 | 0.2 | red | Euler |"));
  EXPECT_THAT(page, HasSubstr("**Red.** stress \\<zz>: too coarse"));
}

}  // namespace report_test
