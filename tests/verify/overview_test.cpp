#include "verify/overview.hpp"
#include "whole/ledger_samples.hpp"
#include "support/test.hpp"

namespace overview_test {

/// A case with a row that passes, two of one reason, and one that fails without a reason.
CaseRows rows_of(const std::string& name, const std::string& remark)
{
  Row good = row_that_passes(name);
  good.used = 0.5;
  Row strain = good, red = good, fail = good;
  strain.used = 0.7, strain.quantity = "strain";
  red.verdict = Verdict::red, red.remark = remark, red.used = 1.5;  // does not agree, so not the nearest
  fail.verdict = Verdict::fail;
  return {name, "A " + name, {good, strain, red, red, fail}};
}

TEST(Overview, HasOneLinePerCaseAndEachReasonOnce)
{
  EXPECT_THAT(overview_page(overview_of({rows_of("bar", "too coarse")}), "How to read it."),
      EndsWith("5 rows: 2 pass, 3 red, 0 regression.\n\nHow to read it.\n"
               "| case | | rows | red | regression | nearest to its bound |\n|---|---|---|---|---|---|\n"
               "| [bar](../cases/verification/bar/README.md) | A bar | 5 | 3 (1 FAIL) | 0 | 70 % of 0.2: strain, h = 1 "
               "m, mpm_gp |\n"
               "\n## Red\n\n- **bar**, 2 rows: stress \\<zz>: too coarse\n"));
}

TEST(Overview, ACaseThatIsNotSolvedKeepsWhatThePageSays)
{
  std::string reason = "coarse";
  for (int k = 0; k < 30; ++k) reason += " | and coarse";
  const std::string page = overview_page(overview_of({rows_of("bar", reason), rows_of("rod", "thin")}), "Head.");
  EXPECT_THAT(page, HasSubstr("10 rows: 4 pass, 6 red, 0 regression."));
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("-") || line.starts_with(" ")) {
      EXPECT_LE(line.size(), 120u);
    }
  }

  EXPECT_EQ(overview_page(read_overview(page), "Head."), page);

  CaseRows better = rows_of("rod", "");
  better.rows.resize(2);
  Overview merged = overview_of({better});
  merged.merge(read_overview(page));
  const std::string now = overview_page(merged, "Head.");
  EXPECT_THAT(now, AllOf(HasSubstr("7 rows: 4 pass, 3 red, 0 regression."), HasSubstr("| A rod | 2 | 0 | 0 |"),
                       HasSubstr("- **bar**")));
  EXPECT_THAT(now, Not(HasSubstr("thin")));
}

TEST(Overview, RegressionRowsAreNoPassAndKeepAListOfTheirOwn)
{
  CaseRows bar = rows_of("bar", "too coarse");
  bar.rows[1].verdict = Verdict::regression, bar.rows[1].remark = "no value from outside";
  const std::string page = overview_page(overview_of({bar, rows_of("rod", "thin")}), "Head.");
  EXPECT_THAT(page, HasSubstr("10 rows: 3 pass, 6 red, 1 regression."));
  EXPECT_THAT(page, HasSubstr("| A bar | 5 | 3 (1 FAIL) | 1 | 50 % of 0.2: stress"))
      << "a regression row is not nearest";
  EXPECT_THAT(page, EndsWith("\n## Regression\n\n- **bar**, 1 row: strain: no value from outside\n"));
  EXPECT_EQ(overview_page(read_overview(page), "Head."), page);
}

TEST(Overview, APageWithoutAColumnForRegressionRowsHasNone)
{
  const std::string line = "| [bar](bar/README.md) | A bar | 5 | 1 (1 FAIL) | 70 % of 0.2: strain |\n";
  EXPECT_EQ(read_overview(line).at("bar").red, 1);
  EXPECT_EQ(read_overview(line).at("bar").regression, 0);
}

}  // namespace overview_test
