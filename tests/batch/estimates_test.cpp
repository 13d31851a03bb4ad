#include "batch/estimates.hpp"

#include "batch/samples.hpp"
#include "batch/study_page.hpp"
#include "batch/study_text.hpp"

namespace estimates_test {

Study study_with(const std::string& rule) { return study_of(changed(column_study, "number = 12", rule)); }

const std::string sweep_head = "case = \"column.toml\"\n[estimator]\nkind = \"sweep\"\n";

/// Every third slides, every sixth floods too; the input falls with the number of the slide.
Realisations rows_of(Index n)
{
  Realisations rows;
  for (Index k = 0; k < n; ++k) {
    Realisation r{.number = k,
        .inputs = {k % 3 == 0 ? 4e3 + k : 9e3 + k},
        .slid = k % 3 == 0,
        .flooded = k % 6 == 0,
        .judges_flood = true,
        .wall_s = 2.0,
        .processor_s = 2.0};
    r.outcomes.assign(study_outcomes().size(), 1.0);
    r.outcomes[outcome_number("residual_height")] = r.slid ? 3.0 : 5.0;
    r.outcomes[outcome_number("still_moves")] = k % 12 == 3 ? 1.0 : 0.0;
    rows.emplace(k, r);
  }
  return rows;
}

TEST(Estimates, AFloodWithoutASlideIsExplained)
{
  const Study study = study_with("number = 12");
  Realisations rows = rows_of(12);
  EXPECT_THAT(study_text(study, rows), Not(HasSubstr("without a slide: ground")));
  rows.at(1).flooded = true;
  EXPECT_THAT(study_text(study, rows), HasSubstr("1 realisation floods without a slide: ground sinks below the water"));
}

TEST(Estimates, ProbabilitiesOfEventsWithTheirBounds)
{
  const Study study = study_with("number = 60");
  const StudyEstimates e = estimate(study, rows_of(60));
  EXPECT_TRUE(e.rule_met);
  EXPECT_EQ(e.n_moving_without_slide, 0) << "all that move have slid";
  EXPECT_EQ(e.n_moving_without_flood, 5);
  EXPECT_EQ(e.slide.happened, 20);
  EXPECT_EQ(e.flood.happened, 10);
  EXPECT_DOUBLE_EQ(*e.flood_after_slide.probability(), 0.5);
  EXPECT_EQ(e.flood_after_slide.bounds.low, clopper_pearson(10, 20, 0.95).low);
  EXPECT_LT(*e.sensitivities[0].with_slide, -0.7);
  EXPECT_GT(*e.sensitivities[0].with_height, 0.7);
  EXPECT_THAT(study_text(study, rows_of(60)),
      AllOf(HasSubstr("  P(I)    0.333, 0.217 to 0.467"), HasSubstr("Of 100 slides 50 flood the land (27 to 73)")));
}

TEST(Estimates, SoilThatSlidesAsDrawnIsASlideOfWhichTheFloodIsNotKnown)
{
  const Study study = study_with("number = 60");
  Realisations rows = rows_of(60);
  for (const Index k : {0, 6, 12}) {  // slid and flooded
    rows.at(k).fault = "slides as drawn: no equilibrium", rows.at(k).flooded = false;
    rows.at(k).outcomes.clear();
  }
  rows.at(1).fault = "stopped itself: no number", rows.at(1).outcomes.clear();
  const StudyEstimates e = estimate(study, rows);
  EXPECT_EQ(e.slide.happened, 20) << "as before: these are slides";
  EXPECT_EQ(e.slide.solved, 59);
  EXPECT_EQ(e.flood.happened, 7);
  EXPECT_EQ(e.flood.failed, 4);
  EXPECT_EQ(e.flood.bounds.low, clopper_pearson(7, 60, 0.95).low) << "none of them floods";
  EXPECT_EQ(e.flood.bounds.high, clopper_pearson(11, 60, 0.95).high) << "all of them flood";
  EXPECT_EQ(e.flood_after_slide.solved, 17);
  EXPECT_EQ(e.flood_after_slide.bounds.high, clopper_pearson(11, 21, 0.95).high);
  EXPECT_LT(*e.sensitivities[0].with_slide, -0.7) << "the weakest are among them";
  EXPECT_THAT(study_text(study, rows),
      AllOf(HasSubstr("60 realisations, 56 solved, 3 slide as drawn, 1 failed"), HasSubstr("20 of 59, 1 unknown"),
          HasSubstr("3 realisations slide, first 0: slides as drawn"),
          HasSubstr("it is a slide in P(I), whatever its volume"), HasSubstr("They are no random sample")));
  EXPECT_THAT(page_of_study(study, rows, "now"),
      AllOf(HasSubstr("Of 4 of 60 realisations it is not known. They are no random sample"),
          HasSubstr("not known</td>"), HasSubstr("7 of 56, 4 unknown")));
  EXPECT_THAT(study_csv(study, rows), AllOf(HasSubstr("\n0,0,1,nan,4000,nan"), HasSubstr("\n1,0,nan,nan,9001,nan")));
}

TEST(Estimates, WhatIsNotKnownOfSlidesIsNotZero)
{
  const Study study = study_with("number = 60");
  Realisations rows = rows_of(60);
  for (auto& [number, r] : rows)
    if (r.slid) r.fault = "slides as drawn: no equilibrium", r.flooded = false, r.outcomes.clear();
  const std::string text = study_text(study, rows),
                    words = "How many of 100 slides flood the land is not known: 0 to 100";
  EXPECT_THAT(text, HasSubstr(words));
  EXPECT_THAT(page_of_study(study, rows, "now"), HasSubstr(words));
  EXPECT_THAT(text, Not(HasSubstr("Of 100 slides")));
}

TEST(Estimates, AFloodThatIsNotJudgedIsNotKnown)
{
  const Study study = study_with("number = 60");
  Realisations rows = rows_of(60);
  for (const Index k : {1, 3}) rows.at(k).judges_flood = false;  // the second has slid
  const StudyEstimates e = estimate(study, rows);
  EXPECT_EQ(e.slide.solved, 60);
  EXPECT_EQ(e.flood.solved, 58);
  EXPECT_EQ(e.flood.failed, 2);
  EXPECT_EQ(e.flood.bounds.high, clopper_pearson(12, 60, 0.95).high);
  EXPECT_EQ(e.flood_after_slide.solved, 19);
  EXPECT_EQ(e.flood_after_slide.bounds.high, clopper_pearson(11, 20, 0.95).high);
  EXPECT_EQ(e.n_moving_without_flood, 4) << "of what is judged";
  EXPECT_THAT(study_text(study, rows), HasSubstr("In 2 realisations no water stands above the ground"));
}

TEST(Estimates, SoilThatMovesAtTheEndMaySlideLater)
{
  const Study study = study_with("number = 60");
  Realisations rows = rows_of(60);
  for (auto& [number, r] : rows) r.judges_flood = r.flooded = false;
  for (const Index k : {1, 2, 3}) rows.at(k).outcomes[outcome_number("still_moves")] = 1.0;
  EXPECT_THAT(
      study_text(study, rows), HasSubstr("2 realisations end without a slide while their soil still moves: P(I)"));
}

TEST(Estimates, BoundsAndStopRulesSayWhatTheyAreWorth)
{
  EXPECT_THAT(study_text(study_with("number = 600\ncov = 0.3"), rows_of(600)), HasSubstr("(k - 1)/(n - 1) = "));
  const Study cube = study_of(changed(column_study, "monte_carlo", "latin_hypercube"));
  const std::string page = page_of_study(cube, rows_of(12), "now");
  EXPECT_THAT(page, HasSubstr("as far as independent realisations would say, with 95 % confidence"));
  EXPECT_THAT(page, Not(HasSubstr("of all studies like this one")));
  const Study weak = study_of(changed(column_study, "seed = 3", "seed = 3\nset = { at_strength = 1.2 }"));
  EXPECT_THAT(study_text(weak, rows_of(12)), HasSubstr("All strengths are divided by 1.2 (at_strength)"));
}

TEST(Estimates, OnlyWhatHasNoGapBeforeItCounts)
{
  Realisations rows = rows_of(60);
  rows.erase(7), rows.erase(30);
  const StudyEstimates e = estimate(study_with("number = 60"), rows);
  EXPECT_EQ(e.n_made, 7) << "the quick ones behind it would have more say than the slow one that is missing";
  EXPECT_EQ(e.n_beyond, 51);
  EXPECT_FALSE(e.rule_met);
}

TEST(Estimates, ARuleOnTheCoefficientOfVariationStopsAtTheSameRealisation)
{
  const Study study = study_with("number = 600\ncov = 0.2");
  // F in every sixth, from the first on: the last of 1/0.2^2 = 25 events is realisation 6 x 24
  const TableCounter few(study, rows_of(200));
  EXPECT_TRUE(few.rule_met());
  EXPECT_EQ(few.n(), 145);
  EXPECT_EQ(TableCounter(study, rows_of(600)).n(), 145);
}

TEST(Estimates, ThePageStandsAloneAndSaysWhatTheNumbersMean)
{
  EXPECT_THAT(page_of_study(study_with("number = 60"), rows_of(60), "now"),
      AllOf(StartsWith("<!doctype html>"),
          HasSubstr("The land floods with probability 0.17; with 95 % confidence it lies between"),
          HasSubstr("P(F) over the realisations"), HasSubstr(">clay.su_peak [Pa]</th>"), HasSubstr("not per year"),
          Not(HasSubstr("http://www.example")), Not(HasSubstr("src="))));
}

TEST(Estimates, APageOfASweepShowsTheFirstKeyOfNumbers)
{
  const Study study = study_of(sweep_head + R"([[sweep]]
key = "scheme"
values = ["mpm_gp", "mpm_mixed"]
[[sweep]]
key = "material.clay.su_peak"
values = [6e3, 7e3]
[[sweep]]
key = "material.clay.eta"
values = [5, 6, 7, 8]
)");
  const std::string page = page_of_study(study, rows_without_runs(study, [](Real k) { return k; }), "now");
  EXPECT_THAT(page, AllOf(HasSubstr("Results over <code>material.clay.su_peak</code>"),
                        HasSubstr("material.clay.su_peak [Pa]"), HasSubstr("volume that slid [m^2]"),
                        HasSubstr("A line for each value of scheme, material.clay.eta; 6 of 8 are drawn."),
                        HasSubstr("why there is no result")));
  EXPECT_THAT(page, AllOf(HasSubstr(">mpm_gp, 5<"), HasSubstr(">mpm_mixed, 8<"), Not(HasSubstr(">mpm_mixed, 7<"))))
      << "in the order of the study, from the first to the last";
}

TEST(Estimates, APageOfASweepTakesNumbersWithUnitsAsNumbers)
{
  const Study study = study_of(sweep_head + R"([[sweep]]
key = "material.clay.su_peak"
values = ["6 kPa", "7 kPa", "13 kPa"]
)");
  const std::string page = page_of_study(study, rows_without_runs(study, [](Real k) { return k; }), "now");
  EXPECT_THAT(
      page, AllOf(HasSubstr("Results over <code>material.clay.su_peak</code>"), HasSubstr("material.clay.su_peak [Pa]"),
                HasSubstr(">8000</text>"), HasSubstr(">12000</text>"), HasSubstr(">13 kPa</td>")));
}

// Soil that slides as drawn has no result but that it slides; numbers that differ by rounding are no result either.
TEST(Estimates, APageOfASweepShowsTheEventsAndNoNoise)
{
  const Study study = study_of(sweep_head + R"([[sweep]]
key = "material.clay.su_peak"
values = [6e3, 7e3, 8e3]
)");
  Realisations rows = rows_without_runs(study, [](Real k) { return 1.0 + 1e-8 * k; });
  rows.at(0).slid = true;
  const std::string page = page_of_study(study, rows, "now");
  EXPECT_THAT(page, AllOf(HasSubstr(">slide, I (1: yes)<"), Not(HasSubstr("flood, F")),
                        Not(HasSubstr("A line for each")), Not(HasSubstr(">highest ground that remains<")),
                        HasSubstr("The same in all realisations that are solved: volume that slid [m^2] 1, ")));
}

TEST(Estimates, APageOfSamplesShowsHistogramsAndFields)
{
  const std::string page = page_of_samples(study_of(field_study), 6, "now");
  EXPECT_THAT(page, HasSubstr("Field of <code>material.clay.su_peak</code>"));
  EXPECT_THAT(page, HasSubstr("realisation 3, over the trend: dark 0.5, bright 2"));
  EXPECT_THAT(page, HasSubstr(">clay.su_peak, field</text>"));
  EXPECT_THAT(page, HasSubstr("What 6 realisations of column.toml would be drawn with"));
}

}  // namespace estimates_test
