#include "io/files/summary_json.hpp"
#include "io/files/files.hpp"
#include "io/files/samples.hpp"
#include "support/golden.hpp"
#include <nlohmann/json.hpp>

namespace summary_json_test {

using nlohmann::json;

Summary sample_summary()
{
  Summary summary;
  summary.scheme = "mpm_gp", summary.n_points = 40000, summary.n_cells = 1600, summary.n_steps = 6598;
  summary.dt = 6.0623e-4, summary.wall_s = 33.5;
  summary.point_steps_per_s = 7.9e6, summary.threads = 2, summary.instructions = "avx2", summary.facing = Facing::left,
  summary.free_toe = false, summary.front_x = 13.25, summary.crest_x = 3.75;
  summary.processor = "a processor", summary.passes = {{"stress", 1.5}}, summary.crest_y = 1.9, summary.run_out = 5.25,
  summary.moved_distance = 0.1, summary.moved_volume = 6.5, summary.moved_fraction = 0.4,
  summary.intact_fraction = 0.25;
  summary.slides.push_back(
      {{.begins = 0.2, .stops = {}, .crest_from = 8.0, .crest_to = 6.0, .kinetic_peak = 11.5, .facing = Facing::left},
          {.time = 0.7, .rate = 4.5, .line = {{6.0, 1.9}, {7.5, 0.1}}},
          {.time = 0.3, .rate = 1.5, .line = {{6.5, 1.5}}}, "flood"});
  summary.max_eps_eq_p = 2.5, summary.softened_strain = 0.0625, summary.softened_fraction = {{0.5, 0.125}, {1.0, 0.25}},
  summary.points_su_rose = 4;
  summary.points_eps_eq_p_fell = 3, summary.energy_balance_error = 1e-3, summary.clamped_points = 6,
  summary.points_left = 2, summary.reached_sides = {{"right", 1.5, true}},
  summary.footings = {{"plate", {0.5, -0.25}, {3.0, 4.5}, 7.0, 12.5}};
  summary.strength_water = {{"peat", "su_peak", "high", "start"}, {"clay", "su_peak", "start", {}}};
  summary.method = paper_options(), summary.method->flip = 0.95, summary.method->pressure = Pressure::balanced;
  summary.v_999 = 5.5, summary.residual_height = 3.5, summary.at_strength = 1.25;
  summary.flood = {.verdict = FloodVerdict::floods,
      .water_level = 4.0,
      .water_level_origin = "the river",
      .river = Facing::left,
      .residual_height = 3.5,
      .freeboard = -0.5,
      .width_at_level = 0.0,
      .intact_width = 0.0,
      .first_time_damaged = 0.75,
      .first_time_below = 1.25,
      .below_for = 2.75,
      .below_by = 0.375,
      .at_strength_damaged = 0.8125,
      .at_strength_below = 0.875,
      .stage_damaged = "daily",
      .stage_below = "flood",
      .stage = "after",
      .fastest_node = 0.25,
      .fastest_x = 2.5,
      .fastest_y = 1.5,
      .fastest_soil = "clay",
      .still_moves = true,
      .stage_moving = "high",
      .ravelled_volume = 0.6875,
      .ravelled_depth = 0.9375,
      .margin = 0.0625,
      .profile = ProfileInGround{.width = 3.5, .slope = 2.5, .x = 7.25},
      .criterion = "why",
      .trigger = FloodTrigger{.stage = "weaker", .at_strength = 1.25, .river = 3.75, .before = FloodVerdict::stands}};
  return summary;
}

json written(const Summary& summary, bool finished)
{
  return json::parse(summary_text(summary, finished, {"model_2", "title = \"column\"\n"}));
}

struct SummaryJson : testing::Test {
  const ScratchFolder scratch;
  const std::string path = scratch.path() + "/summary.json";
};

TEST_F(SummaryJson, HoldsEveryNumberUnderItsName)
{
  json text = written(sample_summary(), true);
  EXPECT_EQ(text["terp_version"], TERP_VERSION);
  for (const char* of_the_version : {"terp_version", "checksum"}) text.erase(of_the_version);
  expect_golden("tests/io/files/summary.json", text.dump(1) + '\n');
}

TEST_F(SummaryJson, OfANewerFormatIsRefusedWithItsVersion)
{
  write_file_atomically(path, R"({"terp_version": "9.1", "format": 2, "scheme": "mpm_gp"})");
  EXPECT_EQ(file_error_of([&] { read_summary(path); }),
      "cannot read " + path +
          ": it is of format 2, terp " TERP_VERSION
          " reads formats up to 1\n  terp 9.1 wrote it: read it with that one.");
}

TEST_F(SummaryJson, WhatIsNotANumberIsNull)
{
  Summary summary = sample_summary();
  summary.crest_x.reset();
  summary.second_failure_time = 2.25;
  summary.energy_balance_error = std::nan("");
  summary.softened_fraction = {{0.5, std::nan("")}};
  const json text = written(summary, false);
  EXPECT_TRUE(text["crest_x"].is_null());
  EXPECT_EQ(text["second_failure_time"], 2.25);
  EXPECT_TRUE(text["energy_balance_error"].is_null());
  EXPECT_TRUE(text["softened_fraction"][0]["fraction"].is_null());
  EXPECT_EQ(text["finished"], false);
}

TEST_F(SummaryJson, ARunThatHasNotEndedHasNoVerdictUnlessItFloods)
{
  Summary summary = sample_summary();
  EXPECT_EQ(written(summary, false)["flood"]["verdict"], "floods");  // for good
  for (const FloodVerdict verdict : {FloodVerdict::stands, FloodVerdict::damaged}) {
    summary.flood->verdict = verdict;
    EXPECT_TRUE(written(summary, false)["flood"]["verdict"].is_null());
    EXPECT_EQ(written(summary, true)["flood"]["verdict"], info_of(verdict).name);
  }
  write_summary(path, summary, false, {"model_2", "title = \"column\"\n"});
  EXPECT_FALSE(read_summary(path).values.flood->verdict);
  EXPECT_EQ(read_summary(path).values.flood->first_time_damaged, 0.75);
}

TEST_F(SummaryJson, TheStageThatRunsHasNoEnd)
{
  Summary summary = sample_summary();
  summary.stages = {{"flood", {.start = 0.5, .end = std::nan(""), .steps = 7, .fastest = std::nan("")}}};
  const json stage = written(summary, false)["stages"][0];
  EXPECT_EQ(stage["start"], 0.5);
  EXPECT_TRUE(stage["end"].is_null() && stage["fastest_node"].is_null());
  write_summary(path, summary, false, {"model_2", "title = \"column\"\n"});
  EXPECT_TRUE(std::isnan(read_summary(path).values.stages[0].record.end));
}

TEST_F(SummaryJson, NumbersComeBackToTheBit)
{
  Summary summary = sample_summary();
  summary.front_x = 0.1 + 0.2;
  EXPECT_EQ(written(summary, true)["front_x"].get<Real>(), 0.1 + 0.2);
}

TEST_F(SummaryJson, ACaseThatIsNotUtf8DoesNotStopTheWriting)
{
  EXPECT_NO_THROW(json::parse(summary_text(sample_summary(), true, {"model_2", "# \xff\n"})));
}

TEST_F(SummaryJson, ReadBackItSaysTheSame)
{
  write_summary(path, sample_summary(), true, {"model_2", "title = \"column\"\n"});
  const SavedSummary back = read_summary(path);
  EXPECT_EQ(summary_text(back.values, back.finished, {"model_2", "title = \"column\"\n"}), back.text);
  EXPECT_EQ(back.terp_version, TERP_VERSION);
  EXPECT_EQ(back.values.first_slide_time, 0.2);
}

TEST_F(SummaryJson, WhatAnOlderFileLacksKeepsItsDefault)
{
  write_file_atomically(path, R"({"scheme": "mpm_gp", "points": "many", "second_failure_time": null})");
  const SavedSummary back = read_summary(path);
  EXPECT_EQ(back.values.scheme, "mpm_gp");
  EXPECT_EQ(back.values.n_points, 0);
  EXPECT_FALSE(back.values.second_failure_time.has_value());
  EXPECT_FALSE(back.values.method.has_value());
  EXPECT_FALSE(back.finished);
}

TEST_F(SummaryJson, WithValuesOfAnotherKindIsRefusedByNameOrReadWithoutThem)
{
  for (const std::string value : {"5", "\"x\"", "true", "[5]", "[null]", "[[1,2]]", "[{\"rose\":\"x\"}]"})
    for (const std::string key : {"slides", "reached_sides", "footings", "passes", "softened_fraction"}) {
      write_file_atomically(path, "{\"" + key + "\": " + value + "}");
      const std::string error = file_error_of([&] { read_summary(path); });
      EXPECT_TRUE(error.empty() || error.starts_with("cannot read " + path + ": it is not what terp wrote there"))
          << key << ' ' << value << ": " << error;
    }
  for (const char* key : {"slides", "other"}) {
    write_file_atomically(
        path, "{\"" + std::string(key) + "\": " + std::string(400'000, '[') + std::string(400'000, ']') + "}");
    const std::string error = file_error_of([&] { read_summary(path); });
    EXPECT_TRUE(error.empty() || error.starts_with("cannot read " + path)) << error;
  }
}

TEST_F(SummaryJson, ThatIsNoJsonIsAnErrorThatNamesTheFile)
{
  write_file_atomically(path, "{\"scheme\": ");
  EXPECT_EQ(file_error_of([&] { read_summary(path); }), "cannot read " + path + ": it is not JSON");
}

}  // namespace summary_json_test
