#include "batch/fragility.hpp"

#include "batch/engine.hpp"
#include "batch/fragility_text.hpp"
#include "batch/samples.hpp"
#include "batch/study_folder.hpp"
#include "batch/study_page.hpp"
#include "support/page_data.hpp"
#include "batch/study_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fragility_test {

/// The load is gravity: h in g.
const std::string curve_text = changed(column_study, "number = 12", "number = 8") + R"([fragility]
name = "weight"
unit = "-"
levels = [0.4, 0.8, 1.6]
distribution = "gumbel"
location = 0.5
decimation_height = 0.4
[fragility.set]
"forces.gravity" = [0.0, "-9.81 * h"]
)";

/// Sample s slides at level l where s < slides[l], and floods where s < floods[l].
Realisations rows_of(const Study& study, const std::vector<Index>& slides, const std::vector<Index>& floods)
{
  Realisations rows;
  for (Index k = 0; k < study.n_realisations; ++k) {
    const Index sample = study.sample_of(k);
    const std::size_t level = study.level_of(k);
    Realisation r{.number = k,
        .inputs = {study.settings.fragility->levels[level], 8e3},
        .slid = sample < slides[level],
        .flooded = sample < floods[level],
        .judges_flood = true};
    r.outcomes.assign(study_outcomes().size(), 0.0);
    rows.emplace(k, r);
  }
  return rows;
}

TEST(Fragility, SamplesAreTheSameAtAllLevels)
{
  const Study study = study_of(curve_text), plain = study_of(column_study);
  EXPECT_EQ(study.n_realisations, 24);
  EXPECT_EQ(study.input_names(), (std::vector<std::string>{"weight [-]", "material.clay.su_peak"}));
  for (Index k = 0; k < study.n_realisations; ++k) {
    const Draw draw = draw_realisation(study, k);
    EXPECT_EQ(draw.inputs[0], study.settings.fragility->levels[static_cast<std::size_t>(k % 3)]);
    EXPECT_EQ(draw.inputs[1], draw_realisation(plain, k / 3).inputs[0]) << "that of the study without a load";
  }
  EXPECT_DOUBLE_EQ(case_of(study, draw_realisation(study, 1)).values.forces.gravity[1], -9.81 * 0.8);
}

TEST(Fragility, WeightsIntegrateALineExactly)
{
  const Distribution g = gumbel_of(0.5, 0.4), u{.kind = DistributionKind::uniform, .lowest = 1.0, .highest = 3.0};
  const auto weights = level_weights({0.4, 0.8, 1.6}, g);
  EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-14);
  // a uniform load from 1 to 3 with levels at 1 and 3: half each; of level 2 the mean of a hat
  const auto half = level_weights({1.0, 3.0}, u), hats = level_weights({1.0, 2.0, 3.0}, u);
  EXPECT_NEAR(half[0], 0.5, 1e-12);
  EXPECT_NEAR(hats[0], 0.25, 1e-12);
  EXPECT_NEAR(hats[1], 0.5, 1e-12);
  // P(h) = h over levels far beyond the distribution gives its mean
  std::vector<Real> levels;
  for (int k = 0; k <= 400; ++k) levels.push_back(-2.0 + 0.02 * k);
  const auto many = level_weights(levels, g);
  Real mean = 0.0;
  for (std::size_t k = 0; k < levels.size(); ++k) mean += many[k] * levels[k];
  EXPECT_NEAR(mean, g.mean, 1e-9);
}

// With levels at 1 and 3 a load that lies between them gives the level 3 the weight (its mean - 1)/2.
TEST(Fragility, WeightsOfALoadThatLiesBetweenTwoLevelsAreExact)
{
  const auto upper = [](const Distribution& load) { return level_weights({1.0, 3.0}, load)[1]; };
  EXPECT_NEAR(upper({.kind = DistributionKind::normal, .mean = 1.71, .sd = 1e-3}), 0.355, 1e-10);
  EXPECT_NEAR(upper({.kind = DistributionKind::uniform, .lowest = 1.70, .highest = 1.73}), 0.3575, 1e-10);
  const std::vector<Vec<2>> table{{0.0, 1.2}, {0.3, 1.71}, {0.8, 1.713}, {1.0, 2.9}};
  const Real mean = 0.3 * 1.455 + 0.5 * 1.7115 + 0.2 * 2.3065;
  EXPECT_NEAR(upper({.kind = DistributionKind::quantiles, .table = table}), 0.5 * (mean - 1.0), 1e-10);
}

// P(F) = P(R < h) for a strength R and a load h that are both normal is Phi((m_h - m_R)/sqrt(s_h^2 + s_R^2)).
TEST(Fragility, IntegralOfAKnownCurveIsTheKnownProbability)
{
  const Distribution load{.kind = DistributionKind::normal, .mean = 3.0, .sd = 0.5};
  std::vector<Real> levels;
  for (int k = 0; k <= 8; ++k) levels.push_back(2.0 + 0.5 * k);
  const auto weights = level_weights(levels, load);
  Real p = 0.0;
  for (std::size_t k = 0; k < levels.size(); ++k) p += weights[k] * normal_probability((levels[k] - 5.0) / 0.8);
  const Real exact = normal_probability((3.0 - 5.0) / std::hypot(0.5, 0.8));
  EXPECT_NEAR(p, exact, 0.15 * exact) << "nine levels, half a standard deviation of the load apart";
  EXPECT_GT(p, exact) << "chords lie above a curve that bends upwards";
}

TEST(Fragility, LevelsHaveTheirOwnEventsAndTheIntegralItsBounds)
{
  const Study study = study_of(curve_text);
  const FragilityCurve curve = estimate_fragility(study, rows_of(study, {0, 2, 8}, {0, 1, 4}));
  ASSERT_EQ(curve.levels.size(), 3u);
  EXPECT_DOUBLE_EQ(*curve.levels[1].slide.probability(), 0.25);
  EXPECT_DOUBLE_EQ(*curve.levels[1].flood_after_slide.probability(), 0.5);
  EXPECT_EQ(curve.levels[2].flood.bounds.high, clopper_pearson(4, 8, 0.95).high);
  EXPECT_EQ(curve.n_falling_slides, 0);
  const auto w = level_weights({0.4, 0.8, 1.6}, gumbel_of(0.5, 0.4));
  ASSERT_TRUE(curve.slide && curve.flood);
  EXPECT_NEAR(curve.slide->probability, 0.25 * w[1] + w[2], 1e-14);
  const Real each = 1.0 - 0.05 / 3.0;
  EXPECT_NEAR(
      curve.slide->of_line.low, w[1] * clopper_pearson(2, 8, each).low + w[2] * clopper_pearson(8, 8, each).low, 1e-14);
  EXPECT_LT(curve.slide->rising->low, curve.slide->of_line.low) << "less is known of the curve";
  EXPECT_GT(curve.slide->rising->high, curve.slide->of_line.high);
  const Real above = 1.0 - gumbel_of(0.5, 0.4).probability(1.6);
  EXPECT_NEAR(curve.slide->beyond, above, 1e-14) << "P = 1 at the highest level, 0 at the lowest";
  EXPECT_EQ(estimate_fragility(study, rows_of(study, {3, 2, 8}, {0, 0, 0})).n_falling_slides, 1);
}

TEST(Fragility, ACurveThatFallsHasNoBoundsOfARisingOne)
{
  const Study study = study_of(curve_text);
  const Realisations rows = rows_of(study, {8, 8, 0}, {0, 0, 0});
  const FragilityCurve curve = estimate_fragility(study, rows);
  EXPECT_FALSE(curve.slide->rising);
  EXPECT_TRUE(curve.flood->rising);
  EXPECT_THAT(study_text(study, rows),
      AllOf(HasSubstr("no bounds of a curve that never falls"), HasSubstr("P(I) is lower at a higher level")));
  const auto data = nlohmann::json::parse(study_json(study, rows));
  EXPECT_TRUE(data["slide_over_levels"]["never_falling"].is_null());
  EXPECT_EQ(data["flood_over_levels"]["never_falling"].size(), 2u);
  Realisations gap = rows_of(study, {3, 2, 2}, {0, 0, 0});  // sample 2 slides at the first level alone
  gap.at(2 * 3 + 1).fault = "stopped itself";
  EXPECT_EQ(estimate_fragility(study, gap).n_falling_slides, 1) << "it falls across a level that failed";
}

TEST(Fragility, WhatLiesBeyondIsJudgedByItsUpperBoundToo)
{
  const Study study = study_of(changed(curve_text, "location = 0.5", "location = 2.5"));
  const Realisations rows = rows_of(study, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(estimate_fragility(study, rows).slide->probability, 0.0);
  EXPECT_THAT(study_text(study, rows), HasSubstr("of its upper bound, come from loads beyond 0.4 to 1.6"));
}

std::string dike_case()
{
  std::string text = changed(column_case, "size = [10.0, 3.0]\ncell = 1.0", "size = [8.0, 3.0]\ncell = 0.5");
  text = changed(text, "box = [[0.0, 0.0], [4.0, 2.0]]", "polygon = [[0.0, 0.0], [8.0, 0.0], [5.0, 2.0], [3.0, 2.0]]");
  text = changed(text, "eta = 5.0\n", "eta = 5.0\ndrainage = \"undrained\"\n");
  return changed(text, "left = \"roller\"\n", "") + "[water]\nphreatic_line = [[0.0, 1.0], [8.0, 0.0]]\n[flood]\n";
}

TEST(Fragility, EveryLevelIsJudgedAgainstTheWaterOfOneEnd)
{
  const ScratchFolder folder;
  const auto study = [&](const std::string& land, const std::string& more) {
    const std::string text = changed(curve_text, "\"forces.gravity\" = [0.0, \"-9.81 * h\"]",
        "\"water.phreatic_line\" = [[0.0, \"h\"], [8.0, \"" + land + " + 0*h\"]]" + more);
    return refusal<CaseError>([&] { study_in(folder.path(), text, dike_case()); });
  };
  EXPECT_EQ(study("0", ""), "");
  EXPECT_THAT(
      study("1", ""), HasSubstr("the free water stands higher at the other end of the section than at h = 0.4"));
  EXPECT_EQ(study("1", "\n\"flood.water_level\" = \"h\""), "");
  const Study river = prepare_study(read_study(folder.path() + "/demo.toml"));
  EXPECT_FALSE(is_water_level(*river.settings.fragility)) << "its unit is none";
  EXPECT_THAT(study("-12", ""), HasSubstr("free water stands above the ground at h = 0.8 and not at h = 0.4"));
}

TEST(Fragility, IsSaidInTextTableAndPageAndForDStability)
{
  const Study study = study_of(curve_text);
  const Realisations rows = rows_of(study, {0, 2, 8}, {0, 1, 4});
  const FragilityCurve curve = estimate_fragility(study, rows);
  const std::string text = study_text(study, rows);
  EXPECT_THAT(text, HasSubstr("weight [-], at each level, with 95 % bounds; beta = -Phi^-1(P)\n"));
  EXPECT_THAT(text, HasSubstr("      0.8  0.25, 0.0319 to 0.651         0.67  0.125"));
  EXPECT_THAT(text, HasSubstr("over the gumbel distribution with 50 % 0.5637"));
  const std::string table = fragility_csv(study, curve);
  EXPECT_THAT(table, StartsWith("level,solved,failed,slides,floods,P_I,P_I_low,P_I_high,beta_I,P_F,"));
  EXPECT_THAT(table, HasSubstr("\n0.8,8,0,2,1,0.25,"));
  const auto page = test::data_of(study_payload(study, rows, "now"));
  EXPECT_FALSE(page.contains("growth")) << "a mean over levels is nobody's probability";
  EXPECT_TRUE(page["slide"].is_null());
  EXPECT_EQ(page["judges_flood"], true);
  EXPECT_EQ(page["levels"][1]["slide"]["probability"], 0.25);
  EXPECT_NEAR(page["levels"][1]["slide"]["beta"], 0.6745, 1e-4);
  EXPECT_TRUE(page["levels"][0]["slide"]["beta"].is_null()) << "infinite";
  EXPECT_EQ(page["levels"][2]["flood_after_slide"]["happened"], 4);
  EXPECT_EQ(page["of_load"]["name"], "weight");
  EXPECT_EQ(page["of_load"]["levels"], study.settings.fragility->levels);
  EXPECT_EQ(page["of_load"]["distribution"][50][1],
      study.settings.fragility->distribution->probability(page["of_load"]["distribution"][50][0]));
  const auto json = nlohmann::json::parse(dstability_curve(study, curve, false));
  ASSERT_EQ(json["Calculations"].size(), 1u) << "beta is not finite where nothing happened, or all";
  EXPECT_EQ(json["Calculations"][0]["WaterLevel"], 0.8);
  EXPECT_NEAR(json["Calculations"][0]["Beta"].get<Real>(), 0.6745, 1e-4);
  EXPECT_EQ(json["Calculations"][0]["Label"], "weight 0.8, 2 of 8");
  EXPECT_FALSE(is_water_level(*study.settings.fragility)) << "it is a weight";
  EXPECT_THAT(text, Not(HasSubstr("D-Stability")));
  Node level;
  level.kind = NodeKind::text;
  level.text = "h";
  FragilityLoad river{.unit = "m", .set = {{"water.phreatic_line", level}}};
  EXPECT_TRUE(is_water_level(river));
  river.set[0].second.text = "5 - h";
  EXPECT_FALSE(is_water_level(river)) << "it is a freeboard";
  river.set[0].second.text = "h";
  river.unit = "kPa";
  EXPECT_FALSE(is_water_level(river));
  EXPECT_TRUE(json["Stochasts"].empty());
}

TEST(Fragility, ForContinuInzichtNeverFallsAndIsNeverZero)
{
  FragilityCurve curve;
  const auto add = [&](Real level, Index happened, Index solved) {
    LevelEstimate at;
    at.level = level;
    at.slide.happened = happened, at.slide.solved = solved;
    curve.levels.push_back(at);
  };
  add(1.0, 0, 4), add(2.0, 2, 4), add(3.0, 1, 4), add(4.0, 0, 0);
  EXPECT_EQ(continu_inzicht_csv(curve, false),
      "section_id,failuremechanism_id,measure_id,hydraulicload,failure_probability\n0,0,0,1,1e-200\n0,0,0,2,0.5\n"
      "0,0,0,3,0.5\n");
}

TEST(Fragility, ThePageKnowsTheLevelOfEachRealisation)
{
  const Study study = study_of(curve_text);
  const Realisations rows = rows_of(study, {0, 2, 8}, {0, 1, 4});
  const Payload page = study_payload(study, rows, "now");
  const auto levels = test::column_of(page, test::data_of(page)["outcomes"], "level");
  ASSERT_EQ(levels.size(), rows.size());
  for (const auto& [number, r] : rows) EXPECT_EQ(levels[number], static_cast<float>(study.level_of(number)));
}

TEST(Fragility, ARunSlidesMoreOftenUnderMoreWeight)
{
  const StudyWithStores place(curve_text);
  const Study& study = place.study;
  const Realisations rows = place.run("all", {.threads = 2});
  const std::string folder = place.of("all");
  const FragilityCurve curve = estimate_fragility(study, rows);
  EXPECT_EQ(curve.levels[0].slide.solved, 8);
  EXPECT_LT(curve.levels[0].slide.happened, curve.levels[2].slide.happened);
  EXPECT_EQ(curve.n_falling_slides, 0);
  write_results(study, StudyPlace(folder, "report"), rows, "now");
  EXPECT_TRUE(std::filesystem::exists(folder + '/' + fragility_table));
  EXPECT_FALSE(std::filesystem::exists(folder + '/' + fragility_of_slides)) << "gravity is no water level";
  const Study other = study_of(changed(curve_text, "decimation_height = 0.4", "decimation_height = 0.7"));
  EXPECT_EQ(other.study_digits, study.study_digits) << "the distribution of the load needs no new runs";
  const Study levels = study_of(changed(curve_text, "0.4, 0.8", "0.4, 0.9"));
  EXPECT_NE(levels.study_digits, study.study_digits);
}

TEST(Fragility, WithOneMistakeHasOneMessage)
{
  expect_messages(curve_text,
      {
          {"levels = [0.4, 0.8, 1.6]", "levels = [0.4, 1.6, 0.8]", "Got 0.8 after 1.6."},
          {"levels = [0.4, 0.8, 1.6]", "levels = [0.4]", "`levels` must be a list of numbers that ascend"},
          {"levels = [0.4, 0.8, 1.6]\n", "", "`levels` must be a list of numbers that ascend"},
          {"\"-9.81 * h\"", "\"-9.81 * h +\"", "this is no formula of h"},
          {"\"-9.81 * h\"", "\"log(h - 2)\"", "is no number at h = 0.4"},
          {"\"-9.81 * h\"", "-9.81", "`forces.gravity` does not follow the load"},
          {"[0.0, \"-9.81 * h\"]", "\"h\"", "the case does not take h = 0.4"},
          {"\"forces.gravity\"", "\"forces.gravty\"", "the case does not take h = 0.4"},
          {"\"forces.gravity\" = [0.0, \"-9.81 * h\"]", "", "`set` must say which keys of the case follow the load"},
          {"\"forces.gravity\" = [0.0,", "\"material.clay.su_peak\" = [0.0,", "`material.clay.su_peak` is given twice"},
          {"number = 8", "number = 800\ncov = 0.3",
              "a fragility curve has the same number of realisations at each level"},
          {"location = 0.5", "mean = 0.5", "the distribution is given twice"},
          {"location = 0.5\n", "", "a gumbel distribution needs `location` too"},
          {"decimation_height = 0.4", "decimation_height = -0.4", "`decimation_height` is out of range"},
          {"name = \"weight\"", "nam = \"weight\"", "Did you mean `name`?"},
          {"monte_carlo", "sweep", "a sweep has no fragility curve"},
      });
}

}  // namespace fragility_test
