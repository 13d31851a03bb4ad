#include "batch/estimates.hpp"

#include "batch/samples.hpp"
#include "batch/study_page.hpp"
#include "batch/study_text.hpp"
#include "support/page_data.hpp"

namespace estimates_test {

Study study_with(const std::string& rule) { return study_of(changed(column_study, "number = 12", rule)); }

const std::string sweep_head = "case = \"column.toml\"\n[estimator]\nkind = \"sweep\"\n";

/// Every third slides, every sixth floods too; the input falls with the number of the slide.
/// A third slides, half of these flood; some_move: half of the others still move.
Realisations rows_of(Index n, bool some_move = false)
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
    r.outcomes[outcome_number("still_moves")] = some_move && k % 12 == 3 ? 1.0 : 0.0;
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

TEST(Estimates, OfAFloodOfSoilThatStillMovesAreNotKnown)
{
  const Study study = study_with("number = 60");
  const StudyEstimates e = estimate(study, rows_of(60, true));
  EXPECT_EQ(e.n_moving_without_slide, 0) << "all that move have slid";
  EXPECT_EQ(e.n_moving_without_flood, 5);
  EXPECT_EQ(e.flood.failed, 5);
  EXPECT_EQ(e.flood_after_slide.bounds.low, clopper_pearson(10, 20, 0.95).low) << "none of them floods";
  EXPECT_EQ(e.flood_after_slide.bounds.high, clopper_pearson(15, 20, 0.95).high) << "all of them flood";
  EXPECT_THAT(study_text(study, rows_of(60, true)),
      AllOf(HasSubstr("they count as unknown in P(F) and P(F|I)"), Not(HasSubstr("no water stands above"))));
}

TEST(Estimates, ProbabilitiesOfEventsWithTheirBounds)
{
  const Study study = study_with("number = 60");
  const StudyEstimates e = estimate(study, rows_of(60));
  EXPECT_TRUE(e.rule_met);
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
  const Payload page = study_payload(study, rows, "now");
  const auto data = test::data_of(page);
  EXPECT_EQ(data["flood"]["failed"], 4);
  EXPECT_EQ(data["faults_of"]["1"], "stopped itself: no number");
  EXPECT_THAT(test::column_of(page, data["outcomes"], "state"), testing::Contains(3.0f).Times(3)) << "slide as drawn";
  EXPECT_EQ(test::column_of(page, data["outcomes"], "state")[1], 1.0f);
  EXPECT_TRUE(std::isnan(test::column_of(page, data["outcomes"], "slide")[1]));
  EXPECT_EQ(test::column_of(page, data["outcomes"], "slide")[0], 1.0f);
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
  EXPECT_EQ(test::data_of(study_payload(cube, rows_of(12), "now"))["estimator"], "latin_hypercube");
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

TEST(Estimates, ThePageHasPAsItGrowsAndTheRealisations)
{
  const Study study = study_with("number = 600");
  const Realisations rows = rows_of(600);
  const Payload page = study_payload(study, rows, "now");
  const auto data = test::data_of(page);
  EXPECT_EQ(data["case"], "column.toml");
  EXPECT_EQ(data["event"]["displacement"], 0.3);
  EXPECT_NEAR(data["flood"]["probability"], 1.0 / 6.0, 1e-12);
  const auto& growth = data["growth"]["flood"];
  EXPECT_EQ(growth.size(), 150u) << "every fourth";
  EXPECT_EQ(growth.back()[0], 600);
  EXPECT_EQ(growth.back()[1], data["flood"]["probability"]);
  EXPECT_EQ(growth.back()[2], data["flood"]["low"]);
  EXPECT_EQ(growth.back()[3], data["flood"]["high"]);
  EXPECT_EQ(data["growth"]["slide"][0][3], clopper_pearson(2, 4, 0.95).high);
  EXPECT_EQ(data["inputs"]["columns"][0]["label"], "material.clay.su_peak");
  EXPECT_EQ(data["inputs"]["columns"][0]["unit"], "Pa");
  EXPECT_EQ(data["inputs"]["rows"], 500) << "rows of the table";
  EXPECT_EQ(test::column_of(page, data["inputs"], "material.clay.su_peak")[4], 9004.0f);
  const auto heights = test::column_of(page, data["outcomes"], "residual_height");
  ASSERT_EQ(heights.size(), 600u) << "classes are of all of them";
  EXPECT_EQ(heights[0], 3.0f);
  EXPECT_EQ(heights[599], 5.0f);
}

TEST(Estimates, APageOfASweepHasTheValuesOfItsKeysAsWordsAndNumbers)
{
  const Study study = study_of(sweep_head + R"([[sweep]]
key = "scheme"
values = ["mpm_gp", "mpm_mixed"]
[[sweep]]
key = "material.clay.su_peak"
values = ["6 kPa", "7 kPa", "13 kPa"]
)");
  const Payload page = study_payload(study, rows_without_runs(study, [](Real k) { return k; }), "now");
  const auto data = test::data_of(page);
  EXPECT_TRUE(data["slide"].is_null() && !data.contains("growth")) << "a mean over the sweep is nobody's probability";
  EXPECT_TRUE(data["sweep"][0]["numbers"].is_null());
  EXPECT_EQ(data["sweep"][1]["numbers"], (std::vector<Real>{6e3, 7e3, 13e3}));
  EXPECT_EQ(data["sweep"][1]["of_numbers"], false);
  EXPECT_EQ(data["sweep"][1]["unit"], "Pa");
  EXPECT_EQ(data["words"][5], (std::vector<std::string>{"mpm_mixed", "13 kPa"}));
  EXPECT_EQ(test::column_of(page, data["inputs"], "material.clay.su_peak")[5], 2.0f) << "the place in the list";
}

TEST(Estimates, APageOfSamplesHasHistogramsAndFields)
{
  const Study study = study_of(field_study);
  const Payload page = samples_payload(study, 6, "now");
  const auto data = test::data_of(page);
  EXPECT_EQ(data["samples"], 6);
  EXPECT_EQ(data["inputs"]["columns"][0]["name"], "field");
  EXPECT_EQ(data["inputs"]["rows"], 6);
  const auto& field = data["fields"][0];
  EXPECT_EQ(field["key"], "material.clay.su_peak");
  EXPECT_EQ(field["pictures"]["columns"].size(), 4u);
  const auto values = test::column_of(page, field["pictures"], "3");
  const auto& [low, high] = study.boxes[0];
  const Real across = field["across"], down = static_cast<Real>(values.size()) / across;
  const Vec<2> corner{low[0] + 0.5 / across * (high[0] - low[0]), high[1] - 0.5 / down * (high[1] - low[1])};
  EXPECT_EQ(values[0], static_cast<float>(FieldOverTrend(study, 0, 3).at(corner))) << "from above, from the left";
}

}  // namespace estimates_test
