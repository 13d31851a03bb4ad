#include "batch/adaptive.hpp"
#include "batch/samples.hpp"
#include "batch/fragility.hpp"
#include "batch/study_page.hpp"
#include "support/page_data.hpp"
#include "batch/study_text.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace reliability_test {

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
Repeats repeat(Estimator kind, std::size_t n_numbers, Real cov = 0.0, int n = 50)
{
  Repeats r;
  Real squares = 0.0;
  for (int k = 0; k < n; ++k) {
    const ReliabilityResult result = find_probability(
        {.kind = kind, .n_numbers = n_numbers, .seed = k + 1, .number = 1000, .block = cov > 0.0 ? 1 : 50, .cov = cov},
        plane());
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

// What ends at its own coefficient of variation ends too soon where that came out low by chance, and with it P.
TEST_F(Reliability, ARuleOnTheCoefficientOfVariationLeavesLittleBias)
{
  constexpr int n = 400;
  for (const Real cov : {0.1, 0.3}) {
    const Repeats r = repeat(Estimator::importance_sampling, 2, cov, n);
    EXPECT_NEAR(r.mean, exact, 0.02 * exact + 4.0 * r.cov * exact / std::sqrt(n)) << cov;
    EXPECT_LT(r.cov, 1.3 * cov);
  }
}

TEST_F(Reliability, SubsetSimulationOfAPlane)
{
  for (const std::size_t n : {2u, 100u}) {
    const Repeats r = repeat(Estimator::subset, n, 0.0, 200);
    EXPECT_NEAR(r.mean, exact, 4.0 * r.cov * exact / std::sqrt(200.0)) << n;
    EXPECT_LT(r.cov, 0.4) << n;
    // in 2 variables as it says, in 100 up to 1.3 times that (the remark); each within a tenth for the 200 repeats
    EXPECT_NEAR(r.cov / r.own_cov, n == 2 ? 1.0 : 1.25, n == 2 ? 0.15 : 0.2) << n << ": what the method says of itself";
  }
}

TEST_F(Reliability, WhereNoPlaceHitsTheEventThereIsNoEstimate)
{
  const auto never = [](const std::vector<std::vector<Real>>& scores) {
    std::vector<Real> values;
    for (const auto& u : scores) values.push_back(1.0 + 0.1 * std::exp(-u[0]));
    return values;
  };
  const auto flat = [](const std::vector<std::vector<Real>>& scores) {
    std::vector<Real> values;
    for (const auto& u : scores) values.push_back(std::max(1.0, 3.0 - u[0]));
    return values;
  };
  const ReliabilityRule rule{.kind = Estimator::subset, .n_numbers = 2, .number = 100, .block = 10};
  EXPECT_EQ(find_probability(rule, never).probability, 0.0);
  EXPECT_LE(find_probability(rule, never).at_most, 1e-6);
  const ReliabilityResult plateau =
      find_probability({.kind = Estimator::subset, .n_numbers = 2, .number = 2000, .block = 10}, flat);
  EXPECT_EQ(plateau.probability, 0.0) << "the probability of the plateau is not that of the event";
  EXPECT_NEAR(plateau.at_most, normal_probability(-2.0), 0.01);
  EXPECT_FALSE(plateau.cov);
}

TEST_F(Reliability, AFaultOfTheMethodHasWords)
{
  const LimitState nan = [](const std::vector<std::vector<Real>>& scores) {
    return std::vector<Real>(scores.size(), std::nan(""));
  };
  EXPECT_THAT(refusal<MethodFault>([&] { find_probability({.kind = Estimator::form, .n_numbers = 2}, nan); }),
      HasSubstr("OpenTURNS ended the method: "));
}

TEST(ReliabilityWithoutOpenTurns, SaysWhatToInstall)
{
  if (has_openturns()) GTEST_SKIP() << "this build has OpenTURNS";
  EXPECT_THAT(refusal<CaseError>([] { find_probability({.kind = Estimator::subset}, plane()); }),
      AllOf(HasSubstr("`subset` needs OpenTURNS"), HasSubstr("tools/install-dependencies --study")));
}

const std::string form_study = changed(column_study, "kind = \"monte_carlo\"", "kind = \"form\"\nevent = \"slide\"");

TEST_F(Reliability, ALibraryThatCannotBeOpenedIsNamed)
{
  const ScratchFolder folder;
  const std::string copy = folder.path() + "/terp", study = write_study(folder.path(), form_study);
  std::filesystem::copy_file(program(), copy);
  write_file_atomically(folder.path() + "/terp_openturns.so", "no library");
  const std::string command = copy + " study run " + study + " -o " + folder.path() + "/s > " + copy + ".txt 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_THAT(
      read_file(copy + ".txt"), AllOf(HasSubstr("`form` needs OpenTURNS, which cannot be opened. The system says: "),
                                    HasSubstr("terp_openturns.so"), HasSubstr("tools/install-dependencies --study")));
}

struct Made : StudyWithStores {
  using StudyWithStores::StudyWithStores;
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
  const auto result = replay_adaptive(form.study, rows).result;
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
  EXPECT_FALSE(replay_adaptive(form.study, some).result) << "a place that it asks for is missing";
  EXPECT_THAT(study_text(form.study, rows),
      AllOf(HasSubstr("P(I)"), HasSubstr("a slide: 1 m^2 or more"), HasSubstr("design point"), HasSubstr(" Pa\n")));
  const auto json = nlohmann::json::parse(study_json(form.study, rows));
  EXPECT_EQ(json["rule_met"], true);
  EXPECT_EQ(json["slide"]["probability"], result->probability);
  EXPECT_TRUE(json["slide"]["low"].is_null()) << "FORM knows no bounds";
  EXPECT_EQ(json["method"]["converged"], result->converged);
  EXPECT_EQ(json["method"]["beta"], reliability_index(result->probability));
  EXPECT_EQ(json["method"]["design_values"][0]["value"], strength);
  EXPECT_EQ(json["method"]["design_values"][0]["unit"], "Pa");
  EXPECT_FALSE(test::data_of(study_payload(form.study, rows, "now")).contains("growth")) << "it is no random sample";
  EXPECT_TRUE(json["sensitivities"][0]["with_slide"].is_null()) << "the method chose the places";
  EXPECT_THAT(study_text(form.study, some), HasSubstr("The method is not at its end"));
}

TEST_F(Reliability, AStudyThatWasKilledGoesOnToTheSameBits)
{
  const std::string subset =
      changed(changed(form_study, "kind = \"form\"", "kind = \"subset\"\nblock = 10"), "number = 12", "number = 100");
  Made whole(subset), cut(subset);
  const Realisations rows = whole.run(1);
  ASSERT_GE(rows.size(), 100u);
  const std::string stored = read_file(whole.folder.path() + "/part_1_of_1.rows");
  write_file_atomically(cut.folder.path() + "/part_1_of_1.rows", stored.substr(0, stored.size() / 2));
  const Realisations again = cut.run(2);
  ASSERT_EQ(again.size(), rows.size());
  for (const auto& [number, r] : rows) EXPECT_TRUE(r.same_as(again.at(number))) << number;
  EXPECT_EQ(
      replay_adaptive(cut.study, again).result->probability, replay_adaptive(whole.study, rows).result->probability);
}

TEST_F(Reliability, AStudyOfAnEventThatCannotHappenEndsWithAReport)
{
  // of 8 m2, beside and upon fixed ground: some of it hardly moves
  const std::string never =
      changed(changed(changed(form_study, "\"form\"", "\"subset\"\nblock = 10"), "number = 12", "number = 100"),
          "volume = 1.0", "volume = 7.9");
  Made made(never);
  const Realisations rows = made.run();
  const std::string text = study_text(made.study, rows);
  EXPECT_THAT(text, Not(HasSubstr("beta")));
  EXPECT_THAT(text, AnyOf(HasSubstr("no place that the method tried hit the event"),
                        HasSubstr("realisations are not enough for the method"), HasSubstr("OpenTURNS ended")));
  const auto json = nlohmann::json::parse(study_json(made.study, rows));
  EXPECT_TRUE(json["slide"].is_null());
}

TEST_F(Reliability, FailuresAreNamedAndCountAsTheEvent)
{
  Made form(changed(form_study, "number = 12", "number = 40"));
  Realisations rows = form.run();
  auto& last = rows.rbegin()->second;  // of no step of the search
  last.fault = "stopped itself: a node is too fast", last.outcomes.clear(), last.slid = false;
  const std::string text = study_text(form.study, rows);
  EXPECT_THAT(text, AllOf(ContainsRegex("1 realisation failed, first [0-9]+: stopped itself: a node is too fast"),
                        HasSubstr("Of 1 realisations it is not known: each counts as the event.")));
}

TEST_F(Reliability, ImportanceSamplingOfAFloodNeedsAWaterLevel)
{
  const std::string flood =
      changed(changed(form_study, "\"form\"\nevent = \"slide\"", "\"importance_sampling\"\nevent = \"flood\""),
          "number = 12", "number = 100");
  const ScratchFolder folder;
  EXPECT_THAT(
      refusal<CaseError>([&] { study_of(flood); }), HasSubstr("`event = \"flood\"` needs a case with a water level"));
  const std::string wet =
      column_case + "[flood]\nwater_level = 1.8\nsmallest_width = 3.0\n[initial]\nstress = \"none\"\n";
  const Study study = study_in(folder.path(), flood, wet);
  Realisations rows;
  EXPECT_EQ(run_adaptive(study, folder.path(), {.threads = 2}, never_stop, rows), StudyEnd::rule_met);
  const auto result = replay_adaptive(study, rows).result;
  ASSERT_TRUE(result);
  EXPECT_GE(rows.size(), 100u);
  EXPECT_GT(result->probability, 0.0);
  const auto bounds = rough_bounds(study, *result);
  ASSERT_TRUE(bounds);
  EXPECT_GT(bounds->low, 0.0);
  EXPECT_NEAR(bounds->low * bounds->high, result->probability * result->probability, 1e-12);
  EXPECT_THAT(study_text(study, rows), AllOf(HasSubstr("P(F)"), HasSubstr("with 95 % confidence")));
}

TEST_F(Reliability, AnotherNumberIsAnotherStudy)
{
  const auto digits = [](const char* number) {
    return study_of(changed(form_study, "number = 12", number)).study_digits;
  };
  EXPECT_NE(digits("number = 40"), digits("number = 80")) << "levels and search would go on from other places";
}

// Where no ground is left, the freeboard is not defined; that is the worst flood, and no gap in the limit state.
TEST(Adaptive, TheLimitStateIsAlwaysANumber)
{
  StudySettings s;
  s.adaptive.of_flood = true;
  Realisation r{.slid = true, .flooded = true, .judges_flood = true};
  r.outcomes.assign(study_outcomes().size(), std::nan(""));
  r.outcomes[outcome_number("event_displacement")] = 5.0;
  EXPECT_LT(limit_state_of(s, r), 0.0);
  r.outcomes[outcome_number("freeboard")] = -0.25;
  EXPECT_EQ(limit_state_of(s, r), -0.25);
  r.flooded = r.judges_flood = false;
  EXPECT_EQ(limit_state_of(s, r), -1.0) << "F is not known";
}

TEST(Adaptive, WithOneMistakeHasOneMessage)
{
  expect_messages(form_study,
      {
          {"event = \"slide\"", "event = \"slid\"", "`event` cannot be \"slid\""},
          {"event = \"slide\"", "event = \"slide\"\nblock = 0", "`block` is out of range"},
          {"\"form\"", "\"monte_carlo\"", "`event` is of `kind = \"form\"`, \"importance_sampling\" or \"subset\""},
          {"\"form\"", "\"subset\"", "`subset` takes 160 realisations or more"},
          {"\"form\"", "\"subset\"\nblock = 4", "`subset` takes 100 realisations or more"},
          {"\"form\"", "\"importance_sampling\"", "`importance_sampling` takes 100 realisations or more"},
          {"number = 12", "number = 12\ncov = 0.1", "`form` ends with its `number` of realisations"},
          {"[stop]", "[[field]]\nkey = \"material.clay.eta\"\ncov = 0.1\ntheta = [8, 4]\n[stop]",
              "`form` draws no fields"},
          {"[stop]", "[fragility]\nlevels = [1, 2]\nset = { \"material.clay.eta\" = \"h\" }\n[stop]",
              "a fragility curve needs independent samples"},
      });
}

}  // namespace reliability_test
