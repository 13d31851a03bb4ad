// Methods for rare events on limit states whose probability is known, and a study that replays.
#include "study/adaptive.hpp"
#include "study/samples.hpp"
#include "study/study_text.hpp"
#include "support/test.hpp"

#include <cmath>
#include <numeric>

namespace {

constexpr Real beta = 3.0;
const Real exact = normal_probability(-beta);  // 1.35e-3

/// beta - sum u/sqrt(n): a plane at the distance beta.
LimitState plane()
{
  return [](const std::vector<std::vector<Real>>& scores) {
    std::vector<Real> values;
    for (const auto& u : scores)
      values.push_back(beta - std::accumulate(u.begin(), u.end(), 0.0) / std::sqrt(static_cast<Real>(u.size())));
    return values;
  };
}

class Reliability : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!has_openturns()) GTEST_SKIP() << "this build has no OpenTURNS";
  }
};

struct Repeats {
  Real mean = 0.0, cov = 0.0, own_cov = 0.0;
};
Repeats repeat(Estimator kind, std::size_t n_numbers)
{
  constexpr int n = 50;
  Repeats r;
  Real squares = 0.0;
  for (int k = 0; k < n; ++k) {
    const ReliabilityResult result =
        find_probability({.kind = kind, .n_numbers = n_numbers, .seed = k + 1, .number = 1000, .block = 50}, plane());
    r.mean += result.probability / n, squares += result.probability * result.probability / n;
    r.own_cov += result.cov.value_or(0.0) / n;
  }
  r.cov = std::sqrt(squares - r.mean * r.mean) / r.mean;
  return r;
}

TEST_F(Reliability, FormIsExactForAPlane)
{
  for (const std::size_t n : {2u, 100u}) {
    const ReliabilityResult r = find_probability({.kind = Estimator::form, .n_numbers = n}, plane());
    EXPECT_NEAR(r.probability, exact, 1e-6 * exact);
    EXPECT_TRUE(r.converged);
    EXPECT_NEAR(r.importance[0], 1.0 / static_cast<Real>(n), 1e-6);
    EXPECT_LT(r.n_places, 5 * static_cast<Index>(n) + 20);
  }
}

// Means of 50 repeats of 1000 places, within four of their standard errors.
TEST_F(Reliability, ImportanceSamplingOfAPlane)
{
  for (const std::size_t n : {2u, 100u}) {
    const Repeats r = repeat(Estimator::importance_sampling, n);
    EXPECT_NEAR(r.mean, exact, 4.0 * r.cov * exact / std::sqrt(50.0)) << n;
    EXPECT_LT(r.cov, 0.1) << n;
    EXPECT_NEAR(r.own_cov, r.cov, 0.4 * r.cov) << n << ": what the method says of itself";
  }
}

TEST_F(Reliability, SubsetSimulationOfAPlane)
{
  for (const std::size_t n : {2u, 100u}) {
    const Repeats r = repeat(Estimator::subset, n);
    EXPECT_NEAR(r.mean, exact, 4.0 * r.cov * exact / std::sqrt(50.0)) << n;
    EXPECT_LT(r.cov, 0.4) << n;
  }
}

TEST(ReliabilityWithoutOpenTurns, SaysWhatToInstall)
{
  if (has_openturns()) GTEST_SKIP() << "this build has OpenTURNS";
  EXPECT_THAT(refusal<CaseError>([] { find_probability({.kind = Estimator::subset}, plane()); }),
      AllOf(HasSubstr("`subset` needs OpenTURNS"), HasSubstr("tools/install-dependencies --study")));
}

const std::string form_study = changed(column_study, "kind = \"monte_carlo\"", "kind = \"form\"\nevent = \"slide\"");

struct Made {
  ScratchFolder folder;
  Study study;
  explicit Made(const std::string& text) : study(prepare_study(read_study(write_study(folder.path(), text)))) {}
  Realisations run(int threads = 2)
  {
    Realisations rows = read_store(study, folder.path()).rows;
    EXPECT_EQ(run_adaptive(study, folder.path(), {.threads = threads}, never_stop, rows), StudyEnd::rule_met);
    return rows;
  }
};

TEST_F(Reliability, AStudyFindsTheStrengthAtWhichItSlidesAndReplays)
{
  Made form(changed(form_study, "number = 12", "number = 40"));
  const Realisations rows = form.run();
  const auto result = replay_adaptive(form.study, rows);
  ASSERT_TRUE(result);
  // the strength of the design point parts what slides from what stands
  const Real strength = draw_at(form.study, result->design_point).inputs[0];
  for (const auto& [number, r] : rows) {
    if (r.slid) {
      EXPECT_LT(r.inputs[0], 1.05 * strength) << number;
    } else if (r.solved()) {
      EXPECT_GT(r.inputs[0], 0.95 * strength) << number;
    }
    EXPECT_EQ(limit_state_of(form.study.settings, r) <= 0.0, r.slid || r.failed()) << number;
  }
  Realisations some = rows;
  some.erase(std::prev(some.end()));
  EXPECT_FALSE(replay_adaptive(form.study, some)) << "a place that it asks for is missing";
  EXPECT_THAT(study_text(form.study, rows), AllOf(HasSubstr("P(I)"), HasSubstr("design point")));
  EXPECT_THAT(study_text(form.study, some), HasSubstr("The method is not at its end"));
}

TEST_F(Reliability, AStudyThatWasKilledGoesOnToTheSameBits)
{
  const std::string subset =
      changed(changed(form_study, "kind = \"form\"", "kind = \"subset\"\nblock = 5"), "number = 12", "number = 20");
  Made whole(subset), cut(subset);
  const Realisations rows = whole.run(1);
  ASSERT_GE(rows.size(), 20u);
  const std::string stored = read_file(whole.folder.path() + "/part_1_of_1.rows");
  write_file_atomically(cut.folder.path() + "/part_1_of_1.rows", stored.substr(0, stored.size() / 2));
  const Realisations again = cut.run(2);
  ASSERT_EQ(again.size(), rows.size());
  for (const auto& [number, r] : rows) EXPECT_TRUE(r.same_as(again.at(number))) << number;
  EXPECT_EQ(replay_adaptive(cut.study, again)->probability, replay_adaptive(whole.study, rows)->probability);
}

TEST(Adaptive, WithOneMistakeHasOneMessage)
{
  struct Row {
    const char *from, *to, *expected;
  };
  const Row rows[] = {
      {"event = \"slide\"", "event = \"slid\"", "`event` cannot be \"slid\""},
      {"event = \"slide\"", "event = \"slide\"\nblock = 0", "`block` is out of range"},
      {"\"form\"", "\"monte_carlo\"", "`event` is of a method that chooses its realisations"},
      {"number = 12", "number = 12\ncov = 0.1", "`form` ends with its `number` of realisations"},
      {"[stop]", "[[field]]\nkey = \"material.clay.eta\"\ncov = 0.1\ntheta = [8, 4]\n[stop]", "`form` draws no fields"},
      {"[stop]", "[fragility]\nlevels = [1, 2]\nset = { \"material.clay.eta\" = \"h\" }\n[stop]",
          "a fragility curve needs independent samples"},
  };
  for (const Row& row : rows)
    EXPECT_THAT(refusal<CaseError>([&] { read_study_text(changed(form_study, row.from, row.to), "demo.toml"); }),
        HasSubstr(row.expected))
        << row.to;
}

}  // namespace
