#include "page/reach_page.hpp"
#include "support/test.hpp"

namespace reach_page_test {

ReachSection section_with(FloodVerdict verdict, const std::string& name)
{
  ReachSection section{.record = {.name = name, .title = "High & low"}, .is_solved = true};
  section.summary.residual_height = 3.5;
  section.summary.flood.emplace();
  section.summary.flood->verdict = verdict;
  section.summary.flood->freeboard = -0.5;
  section.record.factor = 1.11, section.record.uncertainty = 0.01;
  section.record.stored = {{"Bishop", 1.004, false}};
  section.profile = {{0.0, 1.0, 1.0}, {5.0, 5.0, 3.5}, {10.0, 1.0, 2.0}};
  section.water_level = 4.0;
  return section;
}

std::vector<ReachSection> sample()
{
  ReachSection slid = section_with(FloodVerdict::floods, "b");
  slid.summary.flood->trigger =
      FloodTrigger{.stage = "weaker_soil", .at_strength = 1.12, .river = 3.5, .before = FloodVerdict::stands};
  ReachSection refused{.record = {.name = "c", .step = "import", .fault = "it is <no> zip file", .is_refused = true}};
  return {section_with(FloodVerdict::stands, "a"), slid, refused};
}

TEST(ReachPage, HasTheVerdictOfEachSectionAndALink)
{
  const std::string page = reach_page(sample(), "en", "2026-01-02T03:04:05Z");
  EXPECT_THAT(page, testing::StartsWith("<!doctype html>\n<html lang=\"en\">"));
  EXPECT_THAT(
      page, HasSubstr("Solved: 2 of 3 sections. Stands: 1; damaged, holds the water: 0; still moving: 0; floods: 1; "
                      "no verdict on the water: 0; no result: 1."));
  EXPECT_THAT(page, HasSubstr("<a href=\"a/run/report.html\" title=\"report page\">a</a>"));
  EXPECT_THAT(page, HasSubstr("<p>High &amp; low</p>"));
  EXPECT_THAT(page, HasSubstr("<p class=\"verdict\">refused</p><p>it is &lt;no&gt; zip file</p>"));
  EXPECT_THAT(page, AllOf(HasSubstr("<p>1.110 ± 0.010</p><p class=\"muted\">stored: Bishop 1.004</p>"),
                        HasSubstr("3.50&nbsp;m</td><td>-0.50&nbsp;m"), testing::Not(HasSubstr("://"))));
}

TEST(ReachPage, SaysATriggerInTheVerdictItself)
{
  EXPECT_THAT(reach_page(sample(), "en", ""),
      HasSubstr("<p class=\"verdict\">floods, after strengths were divided by 1.12 and after the river was brought to "
                "3.50 m</p><p>As it is: stands.</p>"));
  EXPECT_THAT(reach_page(sample(), "nl", ""),
      HasSubstr(
          "<p class=\"verdict\">overstroming, nadat de sterktes door 1,12 zijn gedeeld en nadat de rivier op 3,50 m "
          "is gebracht</p><p>Zoals zij is: blijft staan.</p>"));
  EXPECT_THAT(reach_page(sample(), "nl", ""),
      AllOf(HasSubstr("<p>1,110 ± 0,010</p><p class=\"muted\">opgeslagen: Bishop 1,004</p>"),
          HasSubstr("3,50&nbsp;m</td><td>-0,50&nbsp;m")));
}

TEST(ReachPage, CountsSectionsWithoutAVerdictAndSaysThatThereWasNoneBeforeATrigger)
{
  auto sections = sample();
  sections[0].summary.flood.reset();
  sections[1].summary.flood->trigger->before.reset();
  EXPECT_THAT(reach_page(sections, "en", ""), testing::Not(HasSubstr("As it is")));
  sections[1].summary.stages = {{.name = "as_it_is"}, {.name = "weaker_soil"}};
  const std::string page = reach_page(sections, "en", "");
  EXPECT_THAT(page,
      HasSubstr(
          "Stands: 0; damaged, holds the water: 0; still moving: 0; floods: 1; no verdict on the water: 1; no res"));
  EXPECT_THAT(page, HasSubstr("<p>As it is: no verdict, as it had not come to rest.</p>"));
  EXPECT_THAT(reach_page(sections, "nl", ""), HasSubstr("<p lang=\"en\">it is &lt;no&gt; zip file</p>"));
}

TEST(ReachPage, MarksAVerdictOnSoilThatMoves)
{
  auto sections = sample();
  sections[0].summary.flood->still_moves = true, sections[0].summary.flood->fastest_node = 0.021;
  EXPECT_THAT(reach_page(sections, "en", ""),
      HasSubstr("<p class=\"verdict\">stands <span class=\"mark\">&#9888; not at rest</span></p>"
                "<p class=\"mark\">not at rest at the end (0.021 m/s): the verdict may change</p>"));
  EXPECT_THAT(reach_page(sections, "en", ""), HasSubstr("no result: 1. Not at rest at the end: 1."));
  EXPECT_THAT(reach_page(sections, "nl", ""), HasSubstr("&#9888; niet in rust</span>"));
  EXPECT_THAT(reach_page(sample(), "en", ""), testing::Not(HasSubstr("at rest")));
}

TEST(ReachPage, DrawsTheGroundBeforeAndAfter)
{
  const std::string picture = reach_picture(sample().front());
  EXPECT_THAT(picture, HasSubstr("points=\"4.0,76.0 120.0,4.0 236.0,76.0 \""));
  EXPECT_THAT(picture, HasSubstr("points=\"4.0,76.0 120.0,31.0 236.0,58.0 \""));
  EXPECT_THAT(picture, HasSubstr("stroke-dasharray=\"3 3\" points=\"4.0,22.0 236.0,22.0 \""));
  EXPECT_EQ(reach_picture({}), "");
}

}  // namespace reach_page_test
