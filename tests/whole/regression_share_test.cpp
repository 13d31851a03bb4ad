// The share of regression rows among all rows of the ledger, from the definitions alone.
#include "support/paths.hpp"
#include "support/test.hpp"
#include "verify/find_cases.hpp"
#include "verify/report.hpp"

namespace regression_share_test {

/// Rows of a quantity when all runs are solved. A run without schemes counts as one of a scheme of its own.
int count_rows(const Expected& file, const Quantity& q)
{
  std::map<std::string, int> runs;
  for (const Quantity& measured : file.quantities) {
    if (compares_runs(q) ? measured.name != q.of : &measured != &q) continue;
    for (const Solve& solve : list_solves(file, true, true))
      if (measures(measured, *solve.variant) && names_run(q.runs, solve.variant->name)) ++runs[solve.scheme];
  }
  int rows = 0;
  for (const auto& [scheme, n] : runs)
    if (!compares_runs(q) || q.kind == QuantityKind::mesh_error)
      rows += n;
    else
      rows += n >= least_runs(q) ? 1 : 0;
  return rows;
}

TEST(RegressionShare, AtMostATenthOfTheRowsHoldTerpAgainstItself)
{
  const std::string folder = source_path("cases/verification");
  int rows = 0, regressions = 0;
  for (const std::string& name : names_of_cases(folder)) {
    const Expected file = read_expected(folder + "/" + name + "/expected.toml");
    for (const Quantity& q : file.quantities) {
      if (is_auxiliary(q)) continue;
      const int n = count_rows(file, q);
      EXPECT_GT(n, 0) << name << ": " << q.name;
      rows += n, regressions += q.regression.empty() ? 0 : n;
    }
  }
  EXPECT_GT(regressions, 0);
  EXPECT_FALSE(too_many_regressions(regressions, rows)) << regressions << " of " << rows;
}

}  // namespace regression_share_test
