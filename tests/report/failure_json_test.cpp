#include "report/failure_json.hpp"
#include "support/test.hpp"
#include <nlohmann/json.hpp>

namespace failure_json_test {

const std::vector<float> ground = {0, 2, 6, 2, 8, 0, 12, 0}, outline = {0, 0, 12, 0, 7.75f, 0.5f, 7.6f, 1, 0, 1};

nlohmann::json written(const RunResults& run)
{
  return nlohmann::json::parse(failure_json(run, {ground, outline, 0.5}).dump());
}

TEST(FailureJson, HasTheEventsUnderTheirNames)
{
  RunResults run;
  Summary& s = run.summary.values;
  s.n_steps = 100;
  s.passes = {{"stress", 1.5}};
  s.moved_volume = 6.5, s.crest_x = 4.0;
  s.slides.push_back({{.begins = 0.2, .stops = {}, .crest_from = 8.0, .crest_to = 6.0, .kinetic_peak = 11.0},
      {.time = 0.7, .rate = 4.0, .line = {{6.0, 1.5}, {7.0, 0.5}}},
      {.time = 0.3, .rate = 2.0, .line = {{6.0, 2.0}, {7.0, 0.5}}}});
  const auto json = written(run);
  EXPECT_EQ(json["passes"][0]["name"], "stress");
  EXPECT_EQ(json["events"]["slides"].size(), 1);
  EXPECT_EQ(json["events"]["slides"][0]["begins"], 0.2);
  EXPECT_TRUE(json["events"]["slides"][0]["stops"].is_null());
  EXPECT_EQ(json["events"]["slides"][0]["slip_surface"]["points"][1][0], 7.0);
  EXPECT_EQ(json["events"]["moved_volume"], 6.5);
  EXPECT_EQ(json["events"]["remaining_crest"]["x"], 4.0);
  EXPECT_TRUE(json["events"]["remaining_crest"]["y"].is_null());
  EXPECT_EQ(json["events"]["slides"][0]["entry"]["zone"], "crest");
  EXPECT_EQ(json["events"]["slides"][0]["entry"]["y"], 2.0);
  EXPECT_FLOAT_EQ(json["events"]["slides"][0]["crest_edge"].get<float>(), 7.6f);  // near 8
  s.slides[0].slide.crest_from = 8.4;  // seen farther down the slope: 2 m of height allow 0.4 m more
  EXPECT_FLOAT_EQ(written(run)["events"]["slides"][0]["crest_edge"].get<float>(), 7.6f);
  s.slides[0].slide.crest_from = 9.0;
  EXPECT_TRUE(written(run)["events"]["slides"][0]["crest_edge"].is_null());
  s.slides[0].slide.crest_from = 8.0;
  s.slides.push_back(s.slides[0]);
  EXPECT_TRUE(written(run)["events"]["slides"][1]["crest_edge"].is_null());
  s.slides[1].slide.facing = Facing::left;
  EXPECT_FALSE(written(run)["events"]["slides"][1]["crest_edge"].is_null());
}

TEST(FailureJson, HasTheStageThatRunsWithoutAnEnd)
{
  RunResults run;
  run.summary.values.n_steps = 100;
  run.summary.values.stages = {{"daily", {.start = 0.0, .end = 0.5}}, {"flood", {.start = 0.5, .end = std::nan("")}}};
  const auto stages = written(run)["events"]["stages"];
  EXPECT_EQ(stages[1]["start"], 0.5);
  EXPECT_TRUE(stages[1]["end"].is_null());
}

TEST(FailureJson, HasNoEventsOfASummaryThatIsStillEmpty)
{
  EXPECT_TRUE(written(RunResults{})["events"].is_null());  // killed before its summary was written again
}

}  // namespace failure_json_test
