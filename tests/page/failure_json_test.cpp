#include "page/failure_json.hpp"
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

// On a dike from x = 0 to 20 with a crest of 4 m at a height of 4 m.
const std::vector<float> dike = {-5, 0, 0, 0, 8, 4, 12, 4, 20, 0, 30, 0};

std::optional<EntryPoint> entry_of(std::vector<Vec<2>> line, Facing facing = Facing::right)
{
  SlideSummary slide;
  slide.slide.facing = facing;
  slide.onset.line = std::move(line);
  slide.slip.time = 1.0;
  return entry_point(slide, dike);
}

/// Of a line whose upper end lies on the ground.
std::string zone_of(Vec<2> end, Facing facing)
{
  const auto entry =
      facing == Facing::right ? entry_of({end, {25.0, -1.0}}) : entry_of({{-3.0, -1.0}, end}, Facing::left);
  return entry ? std::string(entry->zone) : "none";
}

TEST(EntryPoint, IsNamedByThePartOfTheSlopeThatSlides)
{
  EXPECT_EQ(zone_of({4.0, 2.0}, Facing::right), "beyond_crest");
  EXPECT_EQ(zone_of({9.0, 4.0}, Facing::right), "crest");
  EXPECT_EQ(zone_of({15.0, 2.5}, Facing::right), "upper_half");
  EXPECT_EQ(zone_of({17.0, 1.5}, Facing::right), "lower_half");
  EXPECT_EQ(zone_of({5.0, 2.5}, Facing::left), "upper_half");
  EXPECT_EQ(zone_of({15.0, 2.5}, Facing::left), "beyond_crest");
  EXPECT_EQ(zone_of({40.0, 0.0}, Facing::left), "none");
}

TEST(EntryPoint, LiesWhereTheLineGoesOnToTheFirstGround)
{
  const auto flat = entry_of({{11.0, 3.2}, {14.0, 3.0}, {25.0, -1.0}});  // 0.8 m below the crest, nearly level
  ASSERT_TRUE(flat);
  EXPECT_NEAR(flat->x, 10.2, 1e-6);  // at 45 degrees
  EXPECT_NEAR(flat->y, 4.0, 1e-6);
  const auto steep = entry_of({{11.0, 3.2}, {12.0, 1.2}, {25.0, -1.0}});
  ASSERT_TRUE(steep);
  EXPECT_NEAR(steep->x, 10.6, 1e-6);  // 2 in 1
  const auto left = entry_of({{-3.0, -1.0}, {8.0, 1.2}, {9.0, 3.2}}, Facing::left);
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->x, 9.4, 1e-6);
}

TEST(EntryPoint, IsNotKnownOfALineThatEndsDeepBelowTheGroundOrAboveIt)
{
  EXPECT_TRUE(entry_of({{10.0, 2.5}, {25.0, -1.0}}));
  EXPECT_FALSE(entry_of({{10.0, 2.3}, {25.0, -1.0}}));  // more than two fifths of 4 m
  EXPECT_TRUE(entry_of({{15.0, 2.6}, {25.0, -1.0}}));
  EXPECT_FALSE(entry_of({{15.0, 3.0}, {25.0, -1.0}}));
  EXPECT_FALSE(entry_of({}));
}

TEST(EntryPoint, IsThatOfTheOnsetNotOfTheFastestShear)
{
  SlideSummary slide;
  slide.slip = {.time = 2.0, .line = {{4.0, 2.0}, {25.0, -1.0}}};
  EXPECT_FALSE(entry_point(slide, dike));
  slide.onset = {.time = 1.0, .line = {{9.0, 4.0}, {25.0, -1.0}}};
  EXPECT_EQ(entry_point(slide, dike)->x, 9.0);
  slide.onset.time = 2.0;  // not seen before
  EXPECT_FALSE(entry_point(slide, dike));
}

}  // namespace failure_json_test
