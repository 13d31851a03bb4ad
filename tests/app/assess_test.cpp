// terp assess, as a user meets it: a reach of small sections, one of which cannot be read.
#include "support/process.hpp"
#include "support/test.hpp"
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

const std::string berm = source_path("tests/dstability/samples/berm-fragility-2023.stix"),
                  example = source_path("tests/dstability/samples/example-2020.03-v1.stix"),
                  nothing = source_path("tests/dstability/samples/empty-2023.stix");

std::vector<std::string> assess_command(
    const std::string& folder, const std::vector<std::string>& files, const std::vector<std::string>& more = {})
{
  std::vector<std::string> words{"assess"};
  words.insert(words.end(), files.begin(), files.end());
  words.insert(words.end(), {"-o", folder, "--cell", "6", "-j", "2", "--threads", "1"});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

nlohmann::json reach_in(const std::string& folder) { return nlohmann::json::parse(text_of(folder + "/reach.json")); }

TEST(Assess, SolvesAReachAndKeepsWhatIsSolved)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/reach";
  const auto words = assess_command(folder, {berm, nothing, example}, {"--trigger", "strength=1.3"});
  const Finished f = test::terp(words);
  EXPECT_EQ(f.status, 3) << f.err;
  EXPECT_THAT(f.out, ContainsRegex("empty-2023 +refused: .*has no soil layer in any stage"));
  EXPECT_THAT(f.out, HasSubstr("2 of 3 sections have a result; page in " + folder + "/index.html"));
  const auto sections = reach_in(folder)["sections"];
  ASSERT_EQ(sections.size(), 3u);
  EXPECT_EQ(sections[0]["name"], "berm-fragility-2023");
  EXPECT_EQ(sections[0]["is_held"], true);  // its stored factor is 0.84
  EXPECT_EQ(sections[0]["state"], "solved");
  EXPECT_EQ(sections[0]["stored"][0]["method"], "BishopBruteForce");
  EXPECT_NEAR(sections[0]["stored"][0]["factor"].get<double>(), 0.840, 1e-3);
  EXPECT_EQ(sections[1]["state"], "refused");
  EXPECT_EQ(sections[2]["flood"]["trigger"]["at_strength"], 1.3);
  EXPECT_THAT(text_of(folder + "/reach.csv"), testing::StartsWith("section,file,title,state,reason,verdict,trigger,"));
  const std::string page = text_of(folder + "/index.html");
  EXPECT_THAT(page, HasSubstr("<a href=\"example-2020.03-v1/run/report.html\""));
  EXPECT_THAT(page, HasSubstr("after strengths were divided by 1.3"));
  EXPECT_TRUE(fs::exists(folder + "/example-2020.03-v1/run/report.html"));

  const Finished again = test::terp(words);
  EXPECT_THAT(again.out, HasSubstr("berm-fragility-2023  kept, solved before\n"));
  EXPECT_THAT(again.out, HasSubstr("example-2020.03-v1  kept, solved before\n"));
  EXPECT_EQ(again.status, 3);
}

TEST(Assess, GoesOnAfterAKill)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/reach";
  const auto words = assess_command(folder, {example}, {"--trigger", "strength=1.3"});
  const std::string run = folder + "/example-2020.03-v1/run";
  {
    Process process(words);
    for (int k = 0; k < 6000 && !fs::exists(run + "/stage_01_stage_1.h5"); ++k) ::usleep(10'000);
    process.send(SIGKILL);
    EXPECT_EQ(process.wait().status, 128 + SIGKILL);
  }
  EXPECT_FALSE(fs::exists(folder + "/index.html"));
  Finished f = test::terp(words);
  for (int k = 0; k < 100 && f.err.find("another terp") != std::string::npos; ++k)
    ::usleep(100'000), f = test::terp(words);  // the section's own process writes a checkpoint and ends
  EXPECT_EQ(f.status, 0) << f.err << f.out;
  EXPECT_THAT(text_of(folder + "/example-2020.03-v1/log.txt"), HasSubstr("check\nrun\ncheck\nrun\n"));
  EXPECT_EQ(reach_in(folder)["sections"][0]["state"], "solved");
}

TEST(Assess, SaysWhatWouldRunAndTakesCasesAsTheyAre)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/reach", section = scratch.path() + "/section";
  ASSERT_EQ(test::terp({"import", example, "--cell", "4", "-o", section}).status, 0);
  const auto words = assess_command(folder, {section, section + "/../" + "section/case.toml"}, {"--estimate"});
  const Finished f = test::terp(words);
  EXPECT_EQ(f.status, 0) << f.err;
  EXPECT_THAT(f.out, ContainsRegex("  section_2 +Stage 2, cells of [0-9.]+ m, [0-9]+ points, at most "));
  EXPECT_THAT(f.out, HasSubstr("nothing was run\n"));
  EXPECT_FALSE(fs::exists(folder + "/index.html"));
}

TEST(Assess, RefusesWhatItCannotBegin)
{
  const ScratchFolder scratch;
  const Finished twice = test::terp({"assess", berm, berm, "-o", scratch.path() + "/reach"});
  EXPECT_EQ(twice.status, 2);
  EXPECT_EQ(twice.err, "error: " + berm + " is given twice\n  Name each section once.\n");
  const Finished trigger = test::terp({"import", berm, "--trigger", "wind", "-o", scratch.path() + "/section"});
  EXPECT_EQ(trigger.status, 2);
  EXPECT_EQ(trigger.err, "error: there is no trigger `wind`\n  Triggers: strength, strength=F, water, water=LEVEL.\n");
  EXPECT_THAT(test::terp({"import", berm, "--trigger", "strength=0.9", "-o", scratch.path() + "/section"}).err,
      HasSubstr("--trigger strength=0.9: `0.9` is not a factor over 1, at most 100\n"));
  EXPECT_THAT(test::terp({"import", berm, "--trigger", "water=high", "-o", scratch.path() + "/section"}).err,
      HasSubstr("--trigger water=high: `high` is not a level in m\n"));
}

TEST(Assess, DoesNotOverwriteACaseThatWasChangedByHand)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/reach", path = folder + "/example-2020.03-v1/case.toml";
  ASSERT_EQ(test::terp(assess_command(folder, {example}, {"--estimate"})).status, 0);
  std::ofstream(path, std::ios::app) << "# by hand\n";
  const Finished other = test::terp(assess_command(folder, {example}, {"--estimate", "--strength", "mean"}));
  EXPECT_THAT(other.out, HasSubstr("was changed by hand, and the file or the options changed, too"));
  EXPECT_THAT(text_of(path), HasSubstr("# by hand"));
  const Finished forced =
      test::terp(assess_command(folder, {example}, {"--estimate", "--strength", "mean", "--force"}));
  EXPECT_EQ(forced.status, 0) << forced.out;
  EXPECT_THAT(text_of(path), testing::Not(HasSubstr("# by hand")));
}

}  // namespace
