#include "io/results/reach.hpp"
#include "io/files/files.hpp"
#include "support/paths.hpp"
#include <nlohmann/json.hpp>

namespace reach_test {

std::vector<std::array<Real, 3>> no_profile(const RunResults&) { return {}; }

SectionRecord sample_record()
{
  return {.name = "dike_1",
      .file = "dike \"1\".stix",
      .title = "High: High",
      .question = "12",
      .program = "78",
      .language = "nl",
      .strength = "deterministic",
      .files = {{"case.toml", "34"}, {"yield.csv", "35"}},
      .files_next = {{"case.toml", "36"}},
      .case_found = "34",
      .run_of = "56",
      .step = "run",
      .is_refused = true,
      .notes = {"The river may be at the left."},
      .notes_nl = {"De rivier ligt wellicht links."},
      .is_done = true,
      .has_report = true,
      .has_trigger = true,
      .is_held = true,
      .trigger = "No trigger was needed.",
      .factor = 1.11,
      .uncertainty = 0.01,
      .stands = 1.1,
      .fails = 1.12,
      .creeps = 1.13,
      .stored = {{"Bishop", 1.0042, false}, {"Spencer", 1.085, true, "design"}},
      .cell = 0.5,
      .n_points = 4000,
      .expected_s = 60.0,
      .seconds = 75.5};
}

ReachSection solved_section()
{
  ReachSection section{.record = sample_record(), .is_solved = true};
  section.record.notes.clear();
  section.summary.residual_height = 3.5;
  section.summary.first_slide_time = 2.25;
  section.summary.flood.emplace();
  FloodSummary& flood = *section.summary.flood;
  flood.verdict = FloodVerdict::floods;
  flood.water_level = 4.0, flood.residual_height = 3.5, flood.freeboard = -0.5;
  flood.first_time_below = 3.0, flood.fastest_node = 0.25;
  section.summary.stages.resize(2);
  section.summary.stages[0].record.at_rest = true;
  section.summary.stages[1].record.fastest = 0.25;
  flood.trigger = FloodTrigger{.stage = "weaker_soil", .at_strength = 1.12, .before = FloodVerdict::stands};
  return section;
}

TEST(Reach, ARecordIsReadAsItWasWritten)
{
  const ScratchFolder scratch;
  EXPECT_EQ(record_text(read_record(scratch.path())), record_text(SectionRecord{}));
  write_file_atomically(scratch.path() + "/section.json", record_text(sample_record()));
  EXPECT_EQ(record_text(read_record(scratch.path())), record_text(sample_record()));
  EXPECT_EQ(read_record(scratch.path()).fails, 1.12);
  write_file_atomically(scratch.path() + "/section.json", "{\"name\": 3}");
  EXPECT_EQ(read_record(scratch.path()).name, "");
}

TEST(Reach, BytesThatAreNoUtf8DoNotStopARecord)
{
  EXPECT_THAT(record_text({.file = "d\xE9.stix"}), HasSubstr("d\xEF\xBF\xBD.stix"));
}

TEST(Reach, ATableHasALinePerSection)
{
  ReachSection refused{
      .record = {
          .name = "b", .file = "b.stix", .step = "import", .fault = "it is no zip file\n  Try.", .is_refused = true}};
  EXPECT_EQ(state_of(refused), "refused");
  EXPECT_EQ(sentence_on(refused), "refused: it is no zip file\n  Try.");
  EXPECT_EQ(state_of({.record = {.step = "check", .fault = "its process was ended by signal 9"}}), "failed");
  EXPECT_THAT(sentence_on(solved_section()), testing::StartsWith("after strengths were divided by 1.12"));
  EXPECT_EQ(reach_csv({solved_section(), refused}),
      "section,file,title,state,reason,verdict,trigger,verdict_before,held,at_rest,fastest_node_m_s,hints,"
      "water_level_m,residual_height_m,freeboard_m,width_at_level_m,first_slide_s,floods_from_s,factor,factor_"
      "uncertainty,stored_factors,cell_m,points,expected_s,"
      "seconds\n"
      "dike_1,\"dike \"\"1\"\".stix\",High: High,solved,,floods,after strengths were divided by "
      "1.12,stands,yes,no,0.25,"
      "held at first: the soil does not stand by itself,4.00,3.50,-0.50,,2.25,3.00,1.110,0.010,"
      "\"Bishop 1.004, Spencer 1.085 (design strengths, other section)\",0.5,4000,60,76\n"
      "b,b.stix,,refused,it is no zip file;   Try.,,,,no,,,,,,,,,,,,,0,0,0,0\n");
}

TEST(Reach, SaysWhereTheVerdictAndTheStoredFactorsOrTheMotionOfTheSoilDisagree)
{
  ReachSection section = solved_section();
  section.record.is_held = false;
  section.record.stored = {{"Bishop", 0.984, false}, {"Spencer", 0.5, true}};
  EXPECT_THAT(hints_on(section), testing::ElementsAre(Hint::stored_below));  // before the trigger
  EXPECT_EQ(words_of(Hint::stored_below, section, false), "stands, but a stored factor is 0.984, below 1");
  FloodSummary& flood = *section.summary.flood;
  flood.trigger.reset();
  EXPECT_THAT(hints_on(section), testing::ElementsAre());  // it floods, and may move
  section.record.stored[0].factor = 1.0;
  EXPECT_THAT(hints_on(section), testing::ElementsAre(Hint::stored_above));
  EXPECT_EQ(words_of(Hint::stored_above, section, true), "loopt over, maar elke opgeslagen factor is ten minste 1,000");
  flood.verdict = FloodVerdict::stands;
  EXPECT_THAT(hints_on(section), testing::ElementsAre(Hint::moves));
  EXPECT_EQ(words_of(Hint::moves, section, false), "not at rest at the end (0.25 m/s): the verdict may change");
  EXPECT_THAT(sentence_on(section), testing::EndsWith(" (not at rest at the end (0.25 m/s): the verdict may change)"));
  const FloodSummary kept = flood;
  section.summary.flood.reset();  // no verdict on the water: the speed is that of the last stage
  EXPECT_EQ(words_of(Hint::moves, section, false), "not at rest at the end (0.25 m/s)");
  EXPECT_EQ(words_of(Hint::moves, section, true), "aan het eind niet in rust (0,25 m/s)");
  EXPECT_THAT(reach_csv({section}), HasSubstr(",no,no,0.25,not at rest at the end (0.25 m/s),"));
  section.summary.flood = kept;
  section.summary.stages.clear();
  EXPECT_EQ(ended_at_rest(section), std::nullopt);
  EXPECT_THAT(hints_on(section), testing::ElementsAre());
  flood.still_moves = true;
  EXPECT_THAT(hints_on(section), testing::ElementsAre(Hint::moves));
  flood.stage = "after", flood.stage_moving = "high", flood.fastest_node = 0.25;
  EXPECT_THAT(words_of(Hint::moves, section, false),
      testing::StartsWith("not at rest at the end of the stage `high` (0.25 m/s)"));
  EXPECT_THAT(words_of(Hint::moves, section, true),
      testing::StartsWith("aan het eind van fase `high` niet in rust (0,25 m/s)"));
}

TEST(Reach, ComparesNoFactorOfOtherStrengthsThanThoseOfTheCase)
{
  ReachSection section = solved_section();
  section.record.is_held = false;
  section.record.stored = {{"Bishop", 0.984, false, "design"}};
  EXPECT_THAT(hints_on(section), testing::ElementsAre());
  section.record.strength = "design";
  EXPECT_THAT(hints_on(section), testing::ElementsAre(Hint::stored_below));
  EXPECT_EQ(stored_text(section.record, true), "Bishop 0,984 (rekenwaarden)");
}

TEST(Reach, SaysWhichOptionsDidNotAct)
{
  ReachSection section = solved_section();
  section.record.is_held = false;
  section.record.ignored = "--river 8 was not applied: a case file is run as it is";
  EXPECT_THAT(hints_on(section), testing::ElementsAre(Hint::ignored));
  EXPECT_EQ(words_of(Hint::ignored, section, false), section.record.ignored);
  EXPECT_EQ(words_of(Hint::ignored, section, true), "niet toegepast (Engels): " + section.record.ignored);
}

TEST(Reach, SaysWhatIsInDoubtSinceTheImport)
{
  ReachSection section = solved_section();
  section.record.is_held = false;
  section.record.notes = {"The river may be at the left.", "Or at the right."};
  section.record.notes_nl = {"De rivier ligt wellicht links.", "Of rechts."};
  ASSERT_THAT(hints_on(section), testing::ElementsAre(Hint::doubt));
  EXPECT_THAT(sentence_on(section),
      testing::EndsWith("(in doubt since the import: The river may be at the left. Or at the right.)"));
  EXPECT_EQ(words_of(Hint::doubt, section, true), "twijfel bij het inlezen: De rivier ligt wellicht links. Of rechts.");
}

TEST(Reach, ALastStageThatEndsAtAFixedTimeSaysNothingOfRest)
{
  ReachSection section = solved_section();
  section.summary.stages[1].record.fastest = std::nan("");
  EXPECT_EQ(ended_at_rest(section), std::nullopt);
  section.summary.flood->verdict = FloodVerdict::stands;
  section.record.is_held = false, section.record.stored.clear();
  EXPECT_THAT(hints_on(section), testing::ElementsAre());
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
  EXPECT_EQ(section["at_rest"], false);
  EXPECT_EQ(section["hints"].size(), 1u);
  EXPECT_EQ(section["hints_nl"].size(), 1u);
  EXPECT_EQ(section["stored_text_nl"], stored_text(solved_section().record, true));
  EXPECT_EQ(section["moves"], false) << "it floods";
  EXPECT_FALSE(section.contains("ground")) << "of the page alone";
  ReachSection drawn = solved_section();
  drawn.profile = {{0.0, 1.0, 1.0}, {5.0, 5.0, 3.5}};
  drawn.summary.flood->verdict = FloodVerdict::stands, drawn.summary.flood->still_moves = true;
  const auto page = nlohmann::json::parse(reach_json({drawn}, "", true))["sections"][0];
  EXPECT_EQ(page["ground"][1], (std::vector<Real>{5.0, 5.0, 3.5}));
  EXPECT_EQ(page["moves"], true);
}

TEST(Reach, ASectionWithoutItsRunHasNoResult)
{
  const ScratchFolder scratch;
  SectionRecord done = sample_record();
  done.is_refused = false;
  write_file_atomically(scratch.path() + "/section.json", record_text(done));
  const ReachSection section = read_section(scratch.path(), no_profile);
  EXPECT_FALSE(section.is_solved);
  EXPECT_THAT(section.record.fault, HasSubstr("summary.json"));
  EXPECT_EQ(state_of(section), "failed");
  SectionRecord open = sample_record();
  open.is_done = false;
  write_file_atomically(scratch.path() + "/section.json", record_text(open));
  EXPECT_EQ(state_of(read_section(scratch.path(), no_profile)), "not finished");
}

TEST(Reach, HasATableForVrtoolOfTheFactorsThatAreKnown)
{
  ReachSection known{.record = sample_record()}, strong = known, none = known;
  strong.record.name = "dike_2", strong.record.factor = 3.0;
  none.record.factor.reset();
  EXPECT_EQ(vrtool_csv({known, none, strong}),
      ",doorsnede,scenario,scenarionaam,scenariokans,SF,beta,stixnaam\n"
      "0,dike_1,1,High: High,1.0,1.11,4.248,\"dike \"\"1\"\".stix\"\n"  // (1.11/1.06 - 0.41)/0.15
      "1,dike_2,1,High: High,1.0,3,8,\"dike \"\"1\"\".stix\"\n");
  EXPECT_EQ(vrtool_csv({none}), "");
}

}  // namespace reach_test
