#include "verify/judge.hpp"
#include "support/test.hpp"

namespace judge_test {

struct Sample {
  Expected file;
  Variant coarse{.name = "coarse"}, fine{.name = "fine"};

  Quantity& add(const std::string& name, Reduce reduce = Reduce::last)
  {
    file.quantities.push_back({.name = name, .source = "book", .reduce = reduce});
    return file.quantities.back();
  }
};

Finding finding(const Quantity& q, Real value, Real reference, Real tolerance)
{
  return {.quantity = &q,
      .run = "coarse",
      .scheme = "mpm_gp",
      .value = value,
      .reference = reference,
      .tolerance = tolerance};
}

Row judge_one(const Sample& s, const Finding& f)
{
  return judge("case", s.file, {{&s.file, &s.coarse, "mpm_gp"}}, {{.findings = {f}, .fault = ""}}).front();
}

TEST(Judge, ANumberIsHeldAgainstItsToleranceOrBound)
{
  Sample s;
  const Quantity& q = s.add("width");
  struct Case {
    Real value, reference;
    Real Finding::*kind;
    Real limit;
    Verdict verdict;
    Real used;
  };
  using enum Verdict;
  for (const Case& c : std::vector<Case>{{2.1, 2.0, &Finding::tolerance, 0.11, pass, 0.1 / 0.11},
           {2.1, 2.0, &Finding::tolerance, 0.09, fail, 0.1 / 0.09},
           {-1.9, -2.0, &Finding::relative, 0.051, pass, 0.05 / 0.051},
           {-1.9, -2.0, &Finding::relative, 0.049, fail, 0.05 / 0.049}, {2.0, NAN, &Finding::at_least, 2.0, pass, 1.0},
           {2.0, NAN, &Finding::at_least, 1.0, pass, 0.5}, {1.99, NAN, &Finding::at_least, 2.0, fail, 2.0 / 1.99},
           {1.99, NAN, &Finding::at_most, 1.98, fail, 1.99 / 1.98}}) {
    Finding f = finding(q, c.value, c.reference, NAN);
    f.*c.kind = c.limit;
    const Row row = judge_one(s, f);
    EXPECT_EQ(row.verdict, c.verdict) << c.value << ' ' << c.limit;
    EXPECT_NEAR(row.used, c.used, 1e-12) << c.value << ' ' << c.limit;
  }
  Finding f = finding(q, 2.0, NAN, NAN);
  f.at_least = -1.0;
  EXPECT_LT(judge_one(s, f).used, 0.0) << "a bound without size";
}

TEST(Judge, ARowSaysTheErrorInTheUnitOfItsTolerance)
{
  Sample s;
  Finding f = finding(s.add("width"), 2.1, 2.0, 0.09);
  const Row row = judge_one(s, f);
  EXPECT_EQ(row.run, "coarse, mpm_gp");
  EXPECT_EQ(row.terp, "2.1");
  EXPECT_EQ(row.error, "0.1");
  EXPECT_EQ(row.tolerance, "0.09");
  f.tolerance = NAN, f.relative = 0.1;
  EXPECT_EQ(judge_one(s, f).error, "5 %");
}

TEST(Judge, WhatIsNoFiniteNumberNeverPasses)
{
  Sample s;
  Finding f = finding(s.add("time"), NAN, 2.0, 1e9);
  EXPECT_EQ(judge_one(s, f).verdict, Verdict::fail);
  EXPECT_EQ(judge_one(s, f).terp, "never");
  EXPECT_EQ(judge_one(s, f).remark, "the formula, or a quantity in it, is not a finite number");
  f.tolerance = NAN, f.at_most = 1.0;
  for (const Real value : {Real{NAN}, -Real{INFINITY}}) {
    f.value = value;
    EXPECT_EQ(judge_one(s, f).verdict, Verdict::fail);
  }
  f.value = INFINITY, f.at_most = NAN, f.at_least = 1.0;
  EXPECT_EQ(judge_one(s, f).verdict, Verdict::fail);
}

TEST(Judge, AQuantityThatCouldNotBeMeasuredIsARowThatFailsBesideTheOthers)
{
  Sample s;
  s.file.quantities.reserve(2);
  const Quantity &bad = s.add("bad"), &good = s.add("good");
  Finding faulty = finding(bad, NAN, NAN, NAN);
  faulty.fault = "no point is `where` this says";
  const auto rows = judge("case", s.file, {{&s.file, &s.coarse, "mpm_gp"}},
      {{.findings = {faulty, finding(good, 2.0, 2.0, 0.1)}, .fault = ""}});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].verdict, Verdict::fail);
  EXPECT_EQ(rows[0].quantity, "bad");
  EXPECT_EQ(rows[0].run, "coarse, mpm_gp");
  EXPECT_EQ(rows[0].remark, "no point is `where` this says");
  EXPECT_EQ(rows[1].verdict, Verdict::pass);
}

TEST(Judge, ARowThatIsDeclaredRedAndAgreesIsMarked)
{
  Sample s;
  Quantity& q = s.add("width");
  EXPECT_FALSE(judge_one(s, finding(q, 2.0, 2.0, 0.1)).declared_red);
  q.red = "cells are too large";
  EXPECT_TRUE(judge_one(s, finding(q, 2.0, 2.0, 0.1)).declared_red);
}

TEST(Judge, ARedRowThatTheCaseDeclaresIsRedAndNotPass)
{
  Sample s;
  Quantity& q = s.add("width");
  q.red = "cells are too large";
  EXPECT_EQ(judge_one(s, finding(q, 3.0, 2.0, 0.1)).verdict, Verdict::red);
  EXPECT_EQ(judge_one(s, finding(q, 3.0, 2.0, 0.1)).remark, "cells are too large");
  EXPECT_EQ(judge_one(s, finding(q, 2.0, 2.0, 0.1)).verdict, Verdict::pass);
  for (const char* other : {"fine", "mpm_mixed", "coarse, mpm_mixed"}) {
    q.red_runs = {other};
    EXPECT_EQ(judge_one(s, finding(q, 3.0, 2.0, 0.1)).verdict, Verdict::fail) << other;
  }
  for (const char* own : {"coarse", "mpm_gp", "coarse, mpm_gp"}) {
    q.red_runs = {"fine", own};
    EXPECT_EQ(judge_one(s, finding(q, 3.0, 2.0, 0.1)).verdict, Verdict::red) << own;
  }
}

TEST(Judge, ARegressionRowNeverPassesAndFailsIfItMisses)
{
  Sample s;
  Quantity& q = s.add("width");
  q.regression = "nobody else has measured it";
  EXPECT_EQ(judge_one(s, finding(q, 2.0, 2.0, 0.1)).verdict, Verdict::regression);
  EXPECT_EQ(judge_one(s, finding(q, 2.0, 2.0, 0.1)).remark, "nobody else has measured it");
  const Row miss = judge_one(s, finding(q, 3.0, 2.0, 0.1));
  EXPECT_EQ(miss.verdict, Verdict::fail);
  EXPECT_TRUE(miss.declared_regression);

  q.red = "cells are too large";
  EXPECT_EQ(judge_one(s, finding(q, 3.0, 2.0, 0.1)).verdict, Verdict::red);
  EXPECT_EQ(judge_one(s, finding(q, 3.0, 2.0, 0.1)).remark, "cells are too large");
  EXPECT_EQ(judge_one(s, finding(q, 2.0, 2.0, 0.1)).verdict, Verdict::regression) << "never pass";
}

TEST(Judge, ARunWithoutResultIsARowThatFails)
{
  const Sample s;
  const auto rows = judge("case", s.file, {{&s.file, &s.coarse, "mpm_gp"}}, {{.findings = {}, .fault = "it stopped"}});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, Verdict::fail);
  EXPECT_EQ(rows[0].remark, "it stopped");
}

TEST(Judge, TheOrderOfConvergenceComparesRunsOfOneScheme)
{
  Sample s;
  s.file.quantities.reserve(2);
  const Quantity& error = s.add("error", Reduce::rms_error);
  Quantity& order = s.add("order");
  order.kind = QuantityKind::order, order.of = "error", order.over = "h", order.at_least = {"1.9", {}};
  const auto run = [&](const std::string& name, Real h, Real value) {
    Finding f = finding(error, value, NAN, 1.0);
    f.run = name, f.constants = {{"h", h}};
    return Solved{.findings = {f}, .fault = ""};
  };
  const auto rows = judge("case", s.file, {{&s.file, &s.coarse, "mpm_gp"}, {&s.file, &s.fine, "mpm_gp"}},
      {run("coarse", 0.5, 0.08), run("fine", 0.25, 0.02)});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[2].terp, "2");
  EXPECT_EQ(rows[2].run, "over h, mpm_gp");
  EXPECT_EQ(rows[2].verdict, Verdict::pass);
}

/// The rows of a quantity that compares n runs, which tend to 5 + shift with the first order; it is to be 5 within gci.
std::vector<Row> rows_of_refined(QuantityKind kind, Real shift, std::size_t n = 3)
{
  Sample s;
  s.file.quantities.reserve(2);
  const Quantity& load = s.add("load");
  Quantity& compared = s.add("compared");
  compared.kind = kind, compared.of = "load", compared.over = "h", compared.tolerance = {"gci", {}},
  compared.reference = {"5", {}};
  std::vector<Solved> runs;
  for (std::size_t k = 0; k < n; ++k) {
    const Real h = 0.5 / static_cast<Real>(1 << k);
    Finding f = finding(load, 5.0 + shift + h, NAN, 1.0);
    f.constants = {{"h", h}};
    runs.push_back({.findings = {f}, .fault = ""});
  }
  auto rows = judge("case", s.file, std::vector<Solve>(n, {&s.file, &s.coarse, "mpm_gp"}), runs);
  std::erase_if(rows, [](const Row& row) { return row.quantity != "compared"; });
  return rows;
}

TEST(Judge, AnExtrapolatedValueIsHeldAgainstItsOwnUncertainty)
{
  const auto rows = rows_of_refined(QuantityKind::extrapolated, 0.1);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, Verdict::pass);  // gci = 1.25 * 0.125
  EXPECT_EQ(rows[0].terp, "5.1");
  EXPECT_EQ(rows_of_refined(QuantityKind::extrapolated, 0.2).at(0).verdict, Verdict::fail);
  EXPECT_TRUE(rows_of_refined(QuantityKind::extrapolated, 0.0, 2).empty()) << "too few: no row";
}

TEST(Judge, ARunMayErrByWhatRefinementShowsOfItsMesh)
{
  const auto verdicts = [](Real shift, std::size_t n) {
    std::vector<Verdict> list;
    for (const Row& row : rows_of_refined(QuantityKind::mesh_error, shift, n)) list.push_back(row.verdict);
    return list;
  };
  using enum Verdict;
  EXPECT_EQ(verdicts(0.0, 3), (std::vector{pass, pass, pass}));
  EXPECT_EQ(verdicts(0.05, 3), (std::vector{pass, pass, fail}));  // 1.25 * 0.125 < 0.125 + 0.05
  EXPECT_TRUE(verdicts(0.0, 2).empty()) << "too few: no row";
}

}  // namespace judge_test
