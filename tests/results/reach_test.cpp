// Tables of a reach.
#include "results/reach.hpp"
#include "output/files.hpp"
#include "support/paths.hpp"
#include "support/test.hpp"
#include <nlohmann/json.hpp>

namespace {

SectionRecord sample_record()
{
  return {.name = "dike_1",
      .file = "dike \"1\".stix",
      .title = "High: High",
      .question = "12",
      .case_found = "34",
      .run_of = "56",
      .step = "run",
      .is_done = true,
      .has_report = true,
      .has_trigger = true,
      .is_held = true,
      .trigger = "No trigger was needed.",
      .factor = 1.11,
      .uncertainty = 0.01,
      .stands = 1.1,
      .fails = 1.12,
      .stored = {{"Bishop", 1.0042, false}, {"Spencer", 1.085, true}},
      .cell = 0.5,
      .n_points = 4000,
      .expected_s = 60.0,
      .seconds = 75.5};
}

ReachSection solved_section()
{
  ReachSection section{.record = sample_record(), .is_solved = true};
  section.summary.residual_height = 3.5;
  section.summary.first_slide_time = 2.25;
  section.summary.flood.emplace();
  FloodSummary& flood = *section.summary.flood;
  flood.verdict = FloodVerdict::floods;
  flood.water_level = 4.0, flood.residual_height = 3.5, flood.freeboard = -0.5;
  flood.first_time_below = 3.0;
  flood.trigger = FloodTrigger{.stage = "weaker_soil", .at_strength = 1.12, .before = FloodVerdict::stands};
  return section;
}

TEST(Reach, ARecordIsReadAsItWasWritten)
{
  const ScratchFolder scratch;
  EXPECT_EQ(record_text(read_record(scratch.path())), record_text({}));
  write_file_atomically(scratch.path() + "/section.json", record_text(sample_record()));
  EXPECT_EQ(record_text(read_record(scratch.path())), record_text(sample_record()));
  EXPECT_EQ(read_record(scratch.path()).fails, 1.12);
  write_file_atomically(scratch.path() + "/section.json", "{\"name\": 3}");
  EXPECT_EQ(read_record(scratch.path()).name, "");
}

TEST(Reach, ATableHasALinePerSection)
{
  ReachSection refused{
      .record = {.name = "b", .file = "b.stix", .step = "import", .fault = "it is no zip file\n  Try."}};
  EXPECT_EQ(state_of(refused), "refused");
  EXPECT_EQ(sentence_on(refused), "refused: it is no zip file\n  Try.");
  EXPECT_THAT(sentence_on(solved_section()), testing::StartsWith("after strengths were divided by 1.12"));
  EXPECT_EQ(reach_csv({solved_section(), refused}),
      "section,file,title,state,reason,verdict,trigger,verdict_before,water_level_m,residual_height_m,freeboard_m,"
      "width_at_level_m,first_slide_s,floods_from_s,factor,factor_uncertainty,stored_factors,cell_m,points,expected_s,"
      "seconds\n"
      "\"dike_1\",\"dike \"\"1\"\".stix\",\"High: High\",solved,\"\",floods,\"after strengths were divided by 1.12\","
      "stands,4.00,3.50,-0.50,,2.25,3.00,1.110,0.010,\"Bishop 1.004, Spencer 1.085 (stale)\",0.5,4000,60,76\n"
      "\"b\",\"b.stix\",\"\",refused,\"it is no zip file;   Try.\",,,,,,,,,,,,\"\",0,0,0,0\n");
}

TEST(Reach, TheSameForAProgram)
{
  const auto json = nlohmann::json::parse(reach_json({solved_section()}, "2026-01-02T03:04:05Z"));
  EXPECT_EQ(json["written"], "2026-01-02T03:04:05Z");
  const auto section = json["sections"][0];
  EXPECT_EQ(section["state"], "solved");
  EXPECT_EQ(section["flood"]["trigger"]["before"], "stands");
  EXPECT_EQ(section["stored"][1]["stale"], true);
  EXPECT_EQ(section["residual_height"], 3.5);
}

TEST(Reach, ASectionWithoutItsRunHasNoResult)
{
  const ScratchFolder scratch;
  write_file_atomically(scratch.path() + "/section.json", record_text(sample_record()));
  const ReachSection section = read_section(scratch.path());
  EXPECT_FALSE(section.is_solved);
  EXPECT_THAT(section.record.fault, HasSubstr("summary.json"));
  EXPECT_EQ(state_of(section), "failed");
  SectionRecord open = sample_record();
  open.is_done = false;
  write_file_atomically(scratch.path() + "/section.json", record_text(open));
  EXPECT_EQ(state_of(read_section(scratch.path())), "not finished");
}

}  // namespace
