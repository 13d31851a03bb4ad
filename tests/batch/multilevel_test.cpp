// Coarse realisations carry P, and pairs on both levels correct it (decision 0056).
#include "batch/multilevel.hpp"

#include "math/philox.hpp"
#include "batch/engine.hpp"
#include "batch/fragility.hpp"
#include "batch/samples.hpp"
#include "batch/study_folder.hpp"
#include "batch/study_page.hpp"
#include "support/page_data.hpp"
#include "batch/study_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace multilevel_test {

/// The fine case has cells of 0.5 m, the coarse one those of the column, 1 m.
const std::string two_levels = changed(changed(column_study, "kind = \"monte_carlo\"",
                                           "kind = \"multilevel\"\ncoarse = { \"mesh.cell\" = 1.0 }\npairs = 5"),
    "seed = 3", "seed = 3\nset = { \"mesh.cell\" = 0.5 }");

/// The coarse level slides with probability 0.2. Of what slides there 0.6 slides with the fine case, of the rest 0.02.
/// Half of what slides floods. So P(I) = 0.136 and P(F) = 0.068.
Realisation synthetic(std::uint32_t study, std::uint32_t sample, bool is_coarse, Real failing = 0.0)
{
  const auto u = [&](std::uint32_t which) { return philox_uniform({sample, which, 78, 0}, {study, 0}); };
  const bool coarse = u(0) < 0.2;
  Realisation r{.number = static_cast<Index>(sample), .judges_flood = true};
  r.slid = is_coarse ? coarse : u(1) < (coarse ? 0.6 : 0.02);
  r.flooded = r.slid && u(2) < 0.5;
  if (r.slid && u(is_coarse ? 3 : 4) < failing) r.fault = "stopped itself", r.slid = r.flooded = false;
  return r;
}

Sample sample_of(const StudySettings& s, std::uint32_t study, std::uint32_t n, std::uint32_t pairs, Real failing = 0.0)
{
  Sample sample(s);
  for (std::uint32_t k = 0; k < n; ++k) {
    sample.take(synthetic(study, k, true, failing), true);
    if (k < pairs) sample.take(synthetic(study, k, false, failing), false);
  }
  return sample;
}

constexpr Real p_slide = 0.136;

bool holds(const EventEstimate& e, Real p) { return e.bounds.low <= p && p <= e.bounds.high; }

struct Spread {
  int n = 0;
  Real sum = 0.0, squares = 0.0;
  void add(Real value) { ++n, sum += value, squares += value * value; }
  Real mean() const { return sum / n; }
  Real variance() const { return squares / n - mean() * mean(); }
  Real error() const { return std::sqrt(variance() / n); }
};

TEST(Multilevel, TheEstimateHasNoBiasAndItsBoundsHoldTheTruth)
{
  const StudySettings s = settings_of(two_levels);
  constexpr int n_studies = 600;
  constexpr std::uint32_t n = 400, pairs = 100;
  Spread slide, flood, worth, of_pairs, of_difference;
  int held = 0, held_flood = 0, held_worth = 0, coarse_held = 0, rough_held = 0;
  for (std::uint32_t study = 0; study < n_studies; ++study) {
    const Sample sample = sample_of(s, study, n, pairs);
    slide.add(*sample.slide().probability()), flood.add(*sample.flood().probability());
    worth.add(*sample.flood_after_slide().probability());
    held += holds(sample.slide(), p_slide), held_flood += holds(sample.flood(), 0.5 * p_slide);
    held_worth += holds(sample.flood_after_slide(), 0.5);
    const TwoLevelCounts& c = sample.levels().of(StudyEvent::slide);
    coarse_held += holds(c.coarse_alone(0.95), p_slide);
    const Bounds rough = c.rough_bounds(0.95).value();
    rough_held += rough.low <= p_slide && p_slide <= rough.high;
    of_pairs.add(static_cast<Real>(c.with.happened + c.without.happened) / pairs);
    of_difference.add(static_cast<Real>(c.coarse) / n + static_cast<Real>(c.gained() - c.lost()) / pairs);
  }
  EXPECT_NEAR(slide.mean(), p_slide, 4.0 * slide.error());
  EXPECT_NEAR(flood.mean(), 0.5 * p_slide, 4.0 * flood.error());
  EXPECT_NEAR(worth.mean(), 0.5, 0.02) << "a quotient has a bias of second order";
  EXPECT_LT(slide.error(), 0.0015);
  EXPECT_GE(held, 0.95 * n_studies);
  EXPECT_GE(held_flood, 0.95 * n_studies);
  EXPECT_GE(held_worth, 0.95 * n_studies);
  // to first order: between the groups 0.2 * 0.8 * 0.58^2 over n, within them 0.2 * 0.6 * 0.4 + 0.8 * 0.02 * 0.98
  const Real variance = 0.0538 / n + 0.0637 / pairs;
  EXPECT_NEAR(slide.variance(), variance, 0.25 * variance) << "four errors of the variance of 600 studies";
  EXPECT_LT(slide.variance(), of_pairs.variance()) << "what the coarse realisations are there for";
  EXPECT_LT(slide.variance(), of_difference.variance()) << "of the coarse share plus the mean difference of pairs";
  EXPECT_GE(rough_held, 0.93 * n_studies) << "not proven, and yet";
  EXPECT_LT(rough_held, held);
  EXPECT_LT(coarse_held, 0.2 * n_studies) << "who trusts the coarse level misses what it does not see";
}

TEST(Multilevel, BoundsHoldWhereRealisationsFail)
{
  const StudySettings s = settings_of(two_levels);
  constexpr int n_studies = 400;
  int held = 0, held_flood = 0, held_worth = 0, n_failed = 0;
  for (std::uint32_t study = 0; study < n_studies; ++study) {
    const Sample sample = sample_of(s, study, 300, 60, 0.4);
    held += holds(sample.slide(), p_slide), held_flood += holds(sample.flood(), 0.5 * p_slide);
    held_worth += holds(sample.flood_after_slide(), 0.5);
    n_failed += static_cast<int>(sample.slide().failed);
    EXPECT_EQ(sample.coarse().n(), sample.levels().of(StudyEvent::slide).n) << "none of the coarse ones is left out";
  }
  EXPECT_GT(n_failed, n_studies) << "of the fine ones, those that slide";
  EXPECT_GE(held, 0.95 * n_studies);
  EXPECT_GE(held_flood, 0.95 * n_studies);
  EXPECT_GE(held_worth, 0.95 * n_studies);
}

/// Counts of one event: coarse realisations and events, then pairs and fine events with and without a coarse one.
TwoLevelCounts counts(std::int64_t n, std::int64_t coarse, PairGroup with, PairGroup without)
{
  return {.n = n, .coarse = coarse, .with = with, .without = without};
}

TEST(Multilevel, TheEstimateIsAProbabilityWhateverThePairsSay)
{
  const auto p = [](const TwoLevelCounts& c) { return c.estimate(0.95).probability(); };
  EXPECT_DOUBLE_EQ(*p(counts(100, 5, {1, 0}, {9, 0})), 0.0) << "and not 5/100 - 1/10";
  EXPECT_DOUBLE_EQ(*p(counts(100, 60, {4, 4}, {6, 6})), 1.0);
  EXPECT_DOUBLE_EQ(*p(counts(100, 20, {4, 3}, {16, 1})), 0.2 * 0.75 + 0.8 / 16.0);
  EXPECT_DOUBLE_EQ(*p(counts(100, 20, {4, 3, 1}, {17, 1, 1})), 0.2 + 0.8 / 16.0) << "of those that are known";
  EXPECT_FALSE(p(counts(100, 5, {0, 0}, {10, 0}))) << "nobody knows what a coarse event is worth";
  EXPECT_FALSE(p(counts(100, 5, {1, 0, 1}, {9, 0})));
  EXPECT_DOUBLE_EQ(*p(counts(100, 0, {0, 0}, {10, 1})), 0.1);
  EXPECT_FALSE(p(counts(0, 0, {}, {})));
  const Bounds nothing = counts(0, 0, {}, {}).estimate(0.95).bounds;
  EXPECT_EQ(nothing.low, 0.0);
  EXPECT_EQ(nothing.high, 1.0);
}

TEST(Multilevel, BoundsAreThoseOfTheSharesAndOfTheFineRealisationsAlone)
{
  // an error of 0.06 in all: a half for the fine realisations alone, 0.01 for each of the three shares
  const auto at = [](std::int64_t k, std::int64_t n) { return clopper_pearson(k, n, 0.99); };
  const Bounds coarse = at(200'000, 1'000'000), few = counts(1000, 200, {6, 3, 1}, {17, 1, 2}).estimate(0.94).bounds;
  EXPECT_DOUBLE_EQ(few.low, clopper_pearson(4, 23, 0.97).low) << "unknown ones count as without the event";
  EXPECT_DOUBLE_EQ(few.high, clopper_pearson(7, 23, 0.97).high) << "and here as with it";
  const EventEstimate many = counts(1'000'000, 200'000, {2000, 1990, 4}, {8000, 10, 5}).estimate(0.94);
  EXPECT_EQ(many.failed, 9);
  EXPECT_DOUBLE_EQ(many.bounds.low, coarse.low * at(1990, 2000).low + (1.0 - coarse.low) * at(10, 8000).low);
  EXPECT_DOUBLE_EQ(many.bounds.high, coarse.high * at(1994, 2000).high + (1.0 - coarse.high) * at(15, 8000).high);
  // where coarse events are worth less than the rest, many of them make P low
  const Bounds other = counts(1'000'000, 200'000, {2000, 0}, {8000, 8000}).estimate(0.94).bounds;
  EXPECT_DOUBLE_EQ(other.low, (1.0 - coarse.high) * at(8000, 8000).low);
}

TEST(Multilevel, SavingsAreThoseOfTheShares)
{
  // a = 0.75, b = 0.05 with half an event more: 15.5/21 and 4.5/81
  const TwoLevelCounts c = counts(400, 80, {20, 15}, {80, 4});
  const LevelSavings s = find_savings(c, 1.0, 10.0, 0.95).value();
  const Real a = 15.5 / 21.0, b = 4.5 / 81.0, p = 0.2 * a + 0.8 * b, between = 0.16 * (a - b) * (a - b),
             within = 0.2 * a * (1.0 - a) + 0.8 * b * (1.0 - b);
  EXPECT_DOUBLE_EQ(within + between, p * (1.0 - p)) << "of the whole";
  EXPECT_DOUBLE_EQ(s.same_variance, p * (1.0 - p) * 10.0 / ((between / 400.0 + within / 100.0) * 1400.0));
  EXPECT_NEAR(s.best_share, std::sqrt(within / (10.0 * between)), 1e-12);
  EXPECT_GE(s.best_same_variance, s.same_variance);
  const auto product = [&](Real share) { return (1.0 + 10.0 * share) * (between + within / share); };
  EXPECT_LT(product(s.best_share), product(1.02 * s.best_share)) << "it is the least";
  EXPECT_LT(product(s.best_share), product(0.98 * s.best_share));
  const Bounds own = c.estimate(0.95).bounds;
  const Real n = *s.same_bounds * 1400.0 / 10.0;
  const Bounds alone = clopper_pearson_of(0.19 * n, n, 0.95);
  EXPECT_NEAR(alone.high - alone.low, own.high - own.low, 1e-9);
  EXPECT_LT(s.same_bounds, 1.0) << "bounds of three shares add up";
  const Bounds rough = c.rough_bounds(0.95).value();
  const Real as_many = p * (1.0 - p) / (between / 400.0 + within / 100.0);
  EXPECT_DOUBLE_EQ(rough.low, clopper_pearson_of(0.19 * as_many, as_many, 0.95).low);
  EXPECT_LT(rough.high - rough.low, own.high - own.low);
  EXPECT_FALSE(find_savings(counts(400, 80, {20, 15, 1}, {80, 4}), 1.0, 10.0, 0.95)->same_bounds);
  EXPECT_FALSE(find_savings(counts(400, 0, {0, 0}, {80, 4}), 1.0, 10.0, 0.95));
  EXPECT_FALSE(find_savings(counts(400, 80, {0, 0}, {80, 4}), 1.0, 10.0, 0.95));
  EXPECT_LE(find_savings(counts(400, 80, {20, 6}, {80, 24}), 1.0, 2.0, 0.95)->best_same_variance, 1.0)
      << "the coarse level says little";
}

TEST(Multilevel, PairsComeFirstAndHaveTheSameInput)
{
  const Study study = study_of(two_levels), plain = study_of(column_study);
  EXPECT_EQ(study.n_realisations, 17);
  EXPECT_EQ(study.n_samples(), 12);
  std::vector<Index> samples;
  for (Index k = 0; k < study.n_realisations; ++k) {
    const Draw draw = draw_realisation(study, k);
    samples.push_back(study.sample_of(k));
    EXPECT_EQ(draw.inputs, draw_realisation(plain, samples.back()).inputs) << "that of Monte Carlo";
    EXPECT_EQ(case_of(study, draw).values.mesh.cell[0], study.is_coarse(k) ? 1.0 : 0.5) << k;
  }
  EXPECT_THAT(samples, ElementsAre(0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 6, 7, 8, 9, 10, 11));
  for (Index turn = 0; turn < 12; ++turn) {
    EXPECT_EQ(study.turn_of(study.first_of_turn(turn)), turn);
    EXPECT_TRUE(study.is_coarse(study.first_of_turn(turn)));
  }
  const Study longer = study_of(changed(two_levels, "number = 12", "number = 20"));
  EXPECT_EQ(longer.study_digits, study.study_digits) << "a larger number goes on with the same study";
  EXPECT_EQ(draw_realisation(longer, 16).changes, draw_realisation(study, 16).changes);
  EXPECT_NE(study_of(changed(two_levels, "pairs = 5", "pairs = 6")).study_digits, study.study_digits);
  EXPECT_NE(study_of(changed(two_levels, "cell\" = 1.0", "cell\" = 0.25")).case_digits, study.case_digits);
}

TEST(Multilevel, TheTableHasTheSameBitsOnThreadsInPartsAndAfterAKill)
{
  const StudyWithStores place(two_levels);
  const std::string table = study_csv(place.study, place.run("one"));
  EXPECT_THAT(table, AllOf(StartsWith("realisation,solved,sample,resolution,slide,flood,material.clay.su_peak,"),
                         HasSubstr("\n0,1,0,coarse,"), HasSubstr("\n1,1,0,fine,"), HasSubstr("\n16,1,11,coarse,")));
  EXPECT_EQ(study_csv(place.study, place.run("two", {.threads = 2})), table);
  for (const Index k : {2, 1}) place.run("parts", {.part = {k, 2}});
  const Realisations first = place.run("first", {.part = {1, 2}});
  EXPECT_TRUE(first.contains(0) && first.contains(1) && !first.contains(2)) << "both of a pair are for one part";
  EXPECT_EQ(study_csv(place.study, place.run("parts")), table);
  const std::string file = "/part_1_of_1.rows", text = read_file(place.of("one") + file);
  write_file_atomically(place.of("cut") + file, text.substr(0, text.size() / 2));
  EXPECT_EQ(study_csv(place.study, place.run("cut", {.threads = 2})), table);
}

// On each level a realisation is that of Monte Carlo with the cells of the level, to the bit.
TEST(Multilevel, EachLevelIsSolvedAsIfItWereTheStudy)
{
  const StudyWithStores place(two_levels), coarse(column_study),
      fine(changed(column_study, "seed = 3", "seed = 3\nset = { \"mesh.cell\" = 0.5 }"));
  const Realisations of_coarse = coarse.run("one"), of_fine = fine.run("one");
  for (auto& [number, r] : place.run("one")) {
    const bool is_coarse = place.study.is_coarse(number);
    Realisation other = (is_coarse ? of_coarse : of_fine).at(place.study.sample_of(number));
    other.number = number;
    EXPECT_TRUE(r.same_as(other)) << number;
  }
  EXPECT_FALSE(differing_outcomes(of_coarse.at(0).outcomes, of_fine.at(0).outcomes).empty());
}

TEST(Multilevel, WithTheSameResultOnBothLevelsItIsTheCoarseShare)
{
  const StudyWithStores place(two_levels);
  Realisations rows = place.run("one");
  for (auto& [number, r] : rows) r.processor_s = place.study.is_coarse(number) ? 1.0 : 8.0;
  for (Index k = 1; k < 10; k += 2) rows.at(k).slid = rows.at(k - 1).slid;
  std::int64_t slid = 0;
  for (const auto& [number, r] : rows) slid += place.study.is_coarse(number) && r.slid;
  ASSERT_GT(slid, 0);
  const StudyEstimates e = estimate(place.study, rows);
  EXPECT_DOUBLE_EQ(*e.slide.probability(), static_cast<Real>(slid) / 12.0);
  EXPECT_EQ(e.slide.solved, 5) << "pairs";
  EXPECT_EQ(e.counts.solved, 17);
  EXPECT_DOUBLE_EQ(e.coarse_s, 1.0);
  EXPECT_NEAR(e.fine_s, 8.0, 1e-12);
  const std::string text = study_text(place.study, rows);
  EXPECT_THAT(text, HasSubstr(" of 5 pairs  a slide: "));
  EXPECT_THAT(text, HasSubstr(fmt::format("note: {} of 12 coarse realisations slide. Of 5 pairs ", slid)));
  EXPECT_THAT(text, HasSubstr("0 lost it with the fine case, 0 gained it. If the coarse case were right, P(I) would"));
  EXPECT_THAT(text,
      HasSubstr(
          "A coarse realisation took 1 s of processor time, a fine one 8 s. Monte Carlo with the fine case alone"));
  EXPECT_THAT(text, HasSubstr("No pair differs, and half a pair is counted as if it did."));
  EXPECT_THAT(text, HasSubstr("rank correlation of inputs with a coarse slide"));
  const Payload page = study_payload(place.study, rows, "now");
  const auto data = test::data_of(page);
  EXPECT_EQ(data["row_labels"], (std::vector<std::string>{"sample", "resolution"}));
  EXPECT_EQ(data["words"][0], (std::vector<std::string>{"0", "coarse"}));
  EXPECT_THAT(test::column_of(page, data["outcomes"], "coarse"), testing::Contains(0.0f).Times(5));
  const auto json = nlohmann::json::parse(study_json(place.study, rows));
  EXPECT_EQ(json["multilevel"]["coarse_realisations"], 12);
  EXPECT_EQ(json["multilevel"]["pairs"], 5);
  EXPECT_EQ(json["multilevel"]["slide"]["coarse"], slid);
  EXPECT_GT(json["multilevel"]["savings"]["same_variance"], 0.0);
}

TEST(Multilevel, WhatIsNotKnownIsToldAndNotMadeUp)
{
  const StudyWithStores place(two_levels);
  Realisations rows;
  for (Index k = 0; k < place.study.n_realisations; ++k) {
    Realisation r{.number = k, .inputs = {8e3 + k}, .slid = k == 12, .processor_s = 1.0};
    r.outcomes.assign(study_outcomes().size(), 0.0);
    rows.emplace(k, r);
  }
  const std::string text = study_text(place.study, rows);
  EXPECT_THAT(text, HasSubstr("  P(I)    -, 0 to "));
  EXPECT_THAT(text, HasSubstr("No pair with a coarse slide is solved: what such a coarse realisation is worth is not"));
  EXPECT_THAT(text, HasSubstr("What two levels save is not known"));
  rows.at(2).fault = "stopped itself: no number";
  EXPECT_THAT(study_text(place.study, rows),
      AllOf(HasSubstr("1 coarse realisation failed: on the coarse level it counts as one without an event"),
          Not(HasSubstr("Failed realisations count in both bounds"))));
  rows.at(3).fault = "stopped itself: no number";
  EXPECT_THAT(study_text(place.study, rows),
      AllOf(HasSubstr("0 of 4 pairs, 1 unknown"), HasSubstr("Failed realisations count in both bounds")));
  EXPECT_TRUE(nlohmann::json::parse(study_json(place.study, rows))["multilevel"]["savings"].is_null());
}

TEST(Multilevel, AFragilityCurveHasTwoLevelsAtEachLoad)
{
  const StudyWithStores place(changed(two_levels, "number = 12", "number = 6") + R"([fragility]
name = "weight"
levels = [0.4, 1.6]
set = { "forces.gravity" = [0.0, "-9.81 * h"] }
distribution = "uniform"
lowest = 0.4
highest = 1.6
)");
  const Study& study = place.study;
  EXPECT_EQ(study.n_realisations, 2 * (6 + 5));
  for (Index k = 0; k < study.n_realisations; ++k) {
    const CaseFile file = case_of(study, draw_realisation(study, k));
    EXPECT_DOUBLE_EQ(file.values.forces.gravity[1], study.level_of(k) == 0 ? -9.81 * 0.4 : -9.81 * 1.6);
    EXPECT_EQ(file.values.mesh.cell[0], study.is_coarse(k) ? 1.0 : 0.5);
  }
  Realisations rows;
  for (Index k = 0; k < study.n_realisations; ++k) {  // sample 0 slides always, 1 and 5 on the coarse level alone
    const Index sample = study.sample_of(k);
    const bool slides = sample == 0 || (study.is_coarse(k) && (sample == 1 || sample == 5));
    Realisation r{.number = k, .inputs = {1.0, 8e3}, .slid = slides && study.level_of(k) == 1};
    r.outcomes.assign(study_outcomes().size(), 0.0);
    rows.emplace(k, r);
  }
  const FragilityCurve curve = estimate_fragility(study, rows);
  EXPECT_DOUBLE_EQ(*curve.levels[0].slide.probability(), 0.0);
  EXPECT_DOUBLE_EQ(*curve.levels[1].slide.probability(), 3.0 / 6.0 * 0.5);
  EXPECT_EQ(curve.n_falling_slides, 0);
  EXPECT_NEAR(curve.slide->probability, 0.125, 1e-12);
  const TwoLevelCounts c = counts(6, 3, {2, 1}, {3, 0});
  EXPECT_EQ(curve.levels[1].slide.bounds.high, c.estimate(0.95).bounds.high);
  EXPECT_NEAR(curve.slide->of_line.high,
      0.5 * (counts(6, 0, {0, 0}, {5, 0}).estimate(0.975).bounds.high + c.estimate(0.975).bounds.high), 1e-12);
}

TEST(Multilevel, WithOneMistakeHasOneMessage)
{
  expect_messages(two_levels,
      {
          {"pairs = 5\n", "\n", "`multilevel` needs `pairs`"},
          {"pairs = 5", "pairs = 0", "`pairs` is out of range"},
          {"pairs = 5", "pairs = 13",
              "there are more pairs than realisations\n\n   12 | pairs = 13\n      |         ^^\n  Got 13, and "
              "`number` is 12."},
          {"coarse = { \"mesh.cell\" = 1.0 }\n", "\n", "`multilevel` needs `coarse`"},
          {"coarse = { \"mesh.cell\" = 1.0 }", "coarse = 2.0", "`coarse` must be a table of keys and values"},
          {"coarse = { \"mesh.cell\" = 1.0 }", "coarse = {}", "`coarse` changes nothing of the case"},
          {"cell\" = 1.0", "cell\" = 0.5", "`coarse` changes nothing of the case"},
          {"cell\" = 1.0", "cell\" = \"50 cm\"", "`coarse` changes nothing of the case"},
          {"\"mesh.cell\" = 1.0", "\"mesh.cel\" = 1.0", "the case does not take `coarse`"},
          {"\"mesh.cell\" = 1.0", "\"mesh.cel\" = 1.0", "unknown key `cel`\n    Did you mean `cell`?"},
          {"\"mesh.cell\" = 1.0", "\"mesh.cell\" = -1.0", "`cell` is out of range\n    Got -1 m"},
          {"\"mesh.cell\" = 1.0", "\"mesh.cell\" = 1.0, \"material.clay.su_peak\" = 9e3",
              "`material.clay.su_peak` and `material.clay.su_peak` set the same value"},
          {"\"multilevel\"", "\"monte_carlo\"", "`coarse` is of `kind = \"multilevel\"`"},
          {"pairs = 5", "pairs = 5\naudit = 0.1", "`audit` is of `kind = \"two_stage\"`"},
          {"pairs = 5", "pairs = 5\nform = \"table\"", "`form` is of `kind = \"sweep\"`"},
          {"pairs = 5", "pairs = 5\nblock = 8",
              "`block` is of `kind = \"form\"`, \"importance_sampling\" or \"subset\""},
          {"number = 12", "number = 1200\ncov = 0.3", "`multilevel` ends with its `number` of realisations"},
          {"[stop]", "[[sweep]]\nkey = \"material.clay.eta\"\nvalues = [1, 2]\n[stop]", "is of `kind = \"sweep\"`"},
      });
}

TEST(Multilevel, ACoarseCaseThatCannotBeginIsRefusedBeforeAllFail)
{
  const ScratchFolder folder;
  const std::string column = changed(column_case, "eta = 5.0", "eta = 5.0\nsoftening = { length = 0.8 }");
  const auto message = [&](const std::string& study) {
    return refusal<CaseError>([&] { study_in(folder.path(), study, column); });
  };
  EXPECT_THAT(message(two_levels), AllOf(HasSubstr("demo.toml:11:10: the coarse case cannot be solved\n"),
                                       HasSubstr("the softening length is shorter than a cell")));
  EXPECT_EQ(message(changed(
                two_levels, "\"mesh.cell\" = 1.0", "\"mesh.cell\" = 1.0, \"material.clay.softening.length\" = 1")),
      "");
}

TEST(Multilevel, AFileThatTheCoarseCaseNamesIsPartOfTheStudyAndIsCopied)
{
  const ScratchFolder folder;
  write_file_atomically(folder.path() + "/soft.csv", "x,y,value\n0,0,6e3\n");
  const std::string text = changed(two_levels, "\"mesh.cell\" = 1.0",
      "\"mesh.cell\" = 1.0, \"material.clay.shear_modulus\" = { csv = \"soft.csv\" }");
  const std::string path = write_study(folder.path(), text);
  const auto digits = [&] { return identity_text(read_study(path)); };
  const std::string before = digits();
  write_file_atomically(folder.path() + "/soft.csv", "x,y,value\n0,0,7e3\n");
  EXPECT_NE(digits(), before);
}

}  // namespace multilevel_test
