#include "math/philox.hpp"
#include "batch/engine.hpp"
#include "batch/samples.hpp"
#include "batch/study_text.hpp"

namespace two_stage_test {

const std::string two_stage_study =
    changed(column_study, "kind = \"monte_carlo\"", "kind = \"two_stage\"\nfactor = 1.3\naudit = 0.25");

/// A realisation as it is drawn: it falls at the factor with probability 0.3; of those that fall a half slides and a
/// quarter floods, of those that stand 2 % slide and 1 % flood. So P(I) = 0.164 and P(F) = 0.082.
Realisation synthetic(std::uint32_t study, std::uint32_t number, Real audit)
{
  const auto u = [&](std::uint32_t which) { return philox_uniform({number, which, 77, 0}, {study, 0}); };
  const bool falls = u(0) < 0.3;
  Realisation r{.number = static_cast<Index>(number), .judges_flood = true};
  r.screening = falls ? Screening::falls : u(1) < audit ? Screening::audited : Screening::skipped;
  if (r.skipped()) return r;
  const Real chance = u(2);
  r.slid = chance < (falls ? 0.5 : 0.02), r.flooded = chance < (falls ? 0.25 : 0.01);
  return r;
}

TEST(TwoStage, TheEstimateHasNoBiasAndItsBoundsHoldTheTruth)
{
  const StudySettings s = settings_of(two_stage_study);
  constexpr int n_studies = 600, n = 150;
  Real sum = 0.0, squares = 0.0;
  int held = 0, held_flood = 0, held_worth = 0, trusting_held = 0;
  for (std::uint32_t study = 0; study < n_studies; ++study) {
    Sample sample(s);
    for (std::uint32_t k = 0; k < n; ++k) sample.take(synthetic(study, k, 0.25));
    const auto holds = [](const EventEstimate& e, Real p) { return e.bounds.low <= p && p <= e.bounds.high; };
    const EventEstimate e = sample.slide();
    const Real p = *e.probability();
    sum += p, squares += p * p;
    held += holds(e, 0.164), held_flood += holds(sample.flood(), 0.082);
    held_worth += holds(sample.flood_after_slide(), 0.5), trusting_held += holds(sample.trusting(false), 0.164);
  }
  const Real mean = sum / n_studies, error = std::sqrt((squares / n_studies - mean * mean) / n_studies);
  EXPECT_NEAR(mean, 0.164, 4.0 * error);
  EXPECT_LT(error, 0.003);
  EXPECT_GE(held, 0.95 * n_studies);
  EXPECT_GE(held_flood, 0.95 * n_studies);
  EXPECT_GE(held_worth, 0.95 * n_studies);
  EXPECT_LT(trusting_held, held) << "who trusts the factor misses what happens above it";
}

/// Numbers of realisations that fall, of those that are audited and of those that are skipped, the last two standing.
struct Stages {
  int falls = 0, falls_slid = 0, falls_failed = 0, audited = 0, audited_slid = 0, audited_failed = 0, skipped = 0;
};
Sample sample_of(const StudySettings& s, const Stages& n)
{
  Sample sample(s);
  const auto take = [&](int count, Screening screening, bool slid, const char* fault) {
    for (int k = 0; k < count; ++k)
      sample.take({.fault = fault, .screening = screening, .slid = slid, .flooded = slid, .judges_flood = true});
  };
  take(n.falls_slid, Screening::falls, true, ""), take(n.falls_failed, Screening::falls, false, "stopped");
  take(n.falls - n.falls_slid - n.falls_failed, Screening::falls, false, "");
  take(n.audited_slid, Screening::audited, true, ""), take(n.audited_failed, Screening::audited, false, "stopped");
  take(n.audited - n.audited_slid - n.audited_failed, Screening::audited, false, "");
  take(n.skipped, Screening::skipped, false, "");
  return sample;
}

TEST(TwoStage, TheEstimateIsAProbabilityWhateverTheAuditFinds)
{
  const StudySettings s = settings_of(changed(two_stage_study, "audit = 0.25", "audit = 0.1"));
  const auto p = [&](const Stages& n) { return sample_of(s, n).slide().probability(); };
  EXPECT_DOUBLE_EQ(*p({.audited = 2, .audited_slid = 2, .skipped = 10}), 1.0) << "not 20/12";
  EXPECT_DOUBLE_EQ(*p({.falls = 4, .falls_slid = 3, .audited = 2, .audited_slid = 1, .skipped = 6}), 0.25 + 8.0 / 24.0);
  EXPECT_DOUBLE_EQ(
      *p({.falls = 4, .falls_slid = 3, .audited = 2, .audited_slid = 1, .audited_failed = 1, .skipped = 6}),
      0.25 + 8.0 / 12.0)
      << "what failed stands for nothing";
  EXPECT_DOUBLE_EQ(*p({.falls = 4, .falls_slid = 1, .falls_failed = 2, .audited = 2, .skipped = 6}), 2.0 / 12.0);
  EXPECT_FALSE(p({.falls = 4, .falls_slid = 3, .audited = 1, .audited_failed = 1, .skipped = 7}))
      << "no audit is known";
  EXPECT_FALSE(p({.falls = 4, .falls_slid = 3, .skipped = 8})) << "nothing was audited";
  const Sample none = sample_of(s, {.falls = 4, .falls_slid = 3, .skipped = 8});
  EXPECT_FALSE(none.flood_after_slide().probability());
  EXPECT_THAT(estimate_text(none.slide()), StartsWith("-, "));
  const Sample many = sample_of(s, {.audited = 60, .audited_slid = 60, .skipped = 0});
  EXPECT_LE(many.slide().bounds.low, 1.0);
  EXPECT_DOUBLE_EQ(*many.flood_after_slide().probability(), 1.0);
}

TEST(TwoStage, WhatTheSlopeIsWorthCountsKnownSlidesForThoseThatFailed)
{
  const StudySettings s = settings_of(two_stage_study);
  Sample sample = sample_of(s, {.falls = 3, .falls_failed = 2, .audited = 2, .audited_slid = 1, .skipped = 0});
  EXPECT_DOUBLE_EQ(*sample.flood_after_slide().probability(), 1.0) << "the one slide that is known flooded";
  sample.take({.screening = Screening::falls, .slid = true, .flooded = false, .judges_flood = true});
  EXPECT_DOUBLE_EQ(*sample.flood_after_slide().probability(), 1.0 / 3.0)
      << "a dry slide below the factor stands for two, as half of what falls failed; the flood above it for itself";
}

TEST(TwoStage, RunsWhatFallsAndTheAuditAndSaysWhatItSaves)
{
  const StudyWithStores place(two_stage_study);
  const Study& study = place.study;
  Realisations rows = place.run("all", {.threads = 2});
  const StudyEstimates e = estimate(study, rows);
  EXPECT_EQ(e.n_made, 12);
  EXPECT_GT(e.sample.run_for_falling().solved, 0);
  EXPECT_GT(e.sample.n_skipped(), 0);
  Real strongest_that_falls = 0.0, weakest_that_stands = 1e9;
  for (const auto& [number, r] : rows) {
    EXPECT_EQ(r.outcomes.empty(), r.skipped());
    if (r.screening == Screening::falls)
      strongest_that_falls = std::max(strongest_that_falls, r.inputs[0]);
    else
      weakest_that_stands = std::min(weakest_that_stands, r.inputs[0]);
  }
  EXPECT_LT(strongest_that_falls, weakest_that_stands) << "one strength decides";
  const Realisations again = read_store(study, place.of("all")).rows;
  for (const auto& [number, r] : rows) EXPECT_TRUE(r.same_as(again.at(number))) << number;
  for (auto& [number, r] : rows) r.processor_s = r.skipped() ? 1.0 : 4.0;
  const std::string text = study_text(study, rows);
  EXPECT_THAT(text, AllOf(HasSubstr("At the factor 1.3 "), HasSubstr("Monte Carlo would have taken")));
  EXPECT_THAT(study_csv(study, rows), HasSubstr("realisation,solved,screening,slide,flood,"));
}

TEST(TwoStage, WithAWholeAuditItIsMonteCarlo)
{
  const StudyWithStores whole(changed(two_stage_study, "audit = 0.25", "audit = 1.0")), plain(column_study);
  const Realisations a = whole.run("all", {.threads = 2});
  Realisations b = plain.run("all", {.threads = 2});
  EXPECT_DOUBLE_EQ(*estimate(whole.study, a).slide.probability(), *estimate(plain.study, b).slide.probability());
  for (auto& [number, r] : b) {
    r.screening = a.at(number).screening;
    EXPECT_TRUE(r.same_as(a.at(number))) << number;
  }
}

TEST(TwoStage, WithOneMistakeHasOneMessage)
{
  expect_messages(two_stage_study,
      {
          {"factor = 1.3\n", "", "`two_stage` needs `factor`"},
          {"factor = 1.3", "factor = 0.9", "`factor` is out of range"},
          {"audit = 0.25", "audit = 0", "`audit` is out of range"},
          {"two_stage", "sobol", "`factor` is of `kind = \"two_stage\"`"},
          {"number = 12", "number = 1200\ncov = 0.3", "`two_stage` ends with its `number` of realisations"},
          {"[stop]", "[fragility]\nlevels = [1, 2]\nset = { \"material.clay.eta\" = \"h\" }\n[stop]",
              "a fragility curve is not found in two stages"},
      });
  const std::string elastic = R"(
[material.clay]
model = "linear_elastic"
density = 1900.0
shear_modulus = 1.0e6
poisson_ratio = 0.45
)";
  std::string column = column_case;
  const std::size_t from = column.find("\n[material.clay]"), to = column.find("[forces]");
  column.replace(from, to - from, elastic);
  const std::string study =
      changed(changed(two_stage_study, "su_peak", "density"), "mean = \"8 kPa\"", "mean = 1900.0");
  EXPECT_THAT(refusal<CaseError>([&] { study_of(study, column); }),
      HasSubstr("no material of this case has a strength to reduce"));
}

}  // namespace two_stage_test
