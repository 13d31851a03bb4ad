// terp assess, as a user meets it: a reach of small sections, one of which cannot be read.
#include "io/files/run_folder.hpp"
#include "support/process.hpp"
#include <csignal>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace assess_test {

namespace fs = std::filesystem;

const std::string berm = source_path("tests/import/dstability/samples/berm-fragility-2023.stix"),
                  example = source_path("tests/import/dstability/samples/example-2020.03-v1.stix"),
                  nothing = source_path("tests/import/dstability/samples/empty-2023.stix");

std::vector<std::string> assess_command(
    const std::string& folder, const std::vector<std::string>& files, const std::vector<std::string>& more = {})
{
  return with(with(with({"assess"}, files), {"-o", folder, "--cell", "4", "-j", "2", "--threads", "1"}), more);
}

nlohmann::json reach_in(const std::string& folder) { return nlohmann::json::parse(text_of(folder + "/reach.json")); }

nlohmann::json record_in(const std::string& section)
{
  return nlohmann::json::parse(text_of(section + "/section.json"));
}

void replace_in(const std::string& path, const std::string& from, const std::string& to)
{
  std::string text = text_of(path);
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  std::ofstream(path) << text.replace(at, from.size(), to);
}

struct Assess : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/reach";
};

TEST_F(Assess, SolvesAReachAndKeepsWhatIsSolved)
{
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
  EXPECT_EQ(sections[0]["flood"]["trigger"]["at_strength"], 1.3);
  EXPECT_TRUE(sections[2]["flood"].is_null());  // its river stands on less than a cell of 4 m
  EXPECT_THAT(text_of(folder + "/reach.csv"), testing::StartsWith("section,file,title,state,reason,verdict,trigger,"));
  const std::string page = text_of(folder + "/index.html");
  EXPECT_THAT(page, AllOf(StartsWith("<!doctype html>"), HasSubstr("\"kind\":\"reach\""), HasSubstr("\"ground\":[["),
                        HasSubstr("\"name\":\"example-2020.03-v1\""), HasSubstr("\"at_strength\":1.3")));
  EXPECT_TRUE(fs::exists(folder + "/example-2020.03-v1/run/report.html"));

  const Finished again = test::terp(words);
  EXPECT_THAT(again.out, HasSubstr("berm-fragility-2023  kept, solved before\n"));
  EXPECT_THAT(again.out, HasSubstr("example-2020.03-v1  kept, solved before\n"));
  EXPECT_EQ(again.status, 3);

  // Changed by hand: the trigger stays in the one, and the other is no longer held.
  std::ofstream(folder + "/example-2020.03-v1/case.toml", std::ios::app) << "# by hand\n";
  replace_in(folder + "/berm-fragility-2023/case.toml", "at_strength = 0.5", "at_strength = 1.0");
  auto checked = words;
  checked.push_back("--estimate");
  EXPECT_EQ(test::terp(checked).status, 3);
  EXPECT_EQ(record_in(folder + "/berm-fragility-2023")["is_held"], false);
  succeeded(test::terp(assess_command(folder, {example}, {"--trigger", "strength=1.3"})));
  EXPECT_EQ(reach_in(folder)["sections"][0]["trigger"], "");
}

TEST_F(Assess, GoesOnAfterAKill)
{
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
  EXPECT_THAT(text_of(folder + "/example-2020.03-v1/log.txt"),
      ContainsRegex("\ncheck\n(.|\n)*\nrun\n(.|\n)*check\n(.|\n)*\nrun\n"));
  EXPECT_EQ(reach_in(folder)["sections"][0]["state"], "solved");
}

TEST_F(Assess, SaysWhatWouldRunAndTakesCasesAsTheyAre)
{
  const std::string section = scratch.path() + "/section";
  succeeded(test::terp({"import", example, "--cell", "4", "-o", section}));
  const auto words = assess_command(folder, {section, section + "/../" + "section/case.toml"},
      {"--estimate", "--river", "1.5", "--between", "-5,40", "--trigger", "water=2"});
  const Finished f = succeeded(test::terp(words));
  EXPECT_THAT(f.out, ContainsRegex("  section_2 +Stage 2, cells of [0-9.]+ m, [0-9]+ points, at most "));
  EXPECT_THAT(f.out, HasSubstr("    --cell 4, --between -5,40, --river 1.5, --trigger water=2 were not applied: a case "
                               "file is run as it is\n"));
  EXPECT_THAT(f.out, HasSubstr("nothing was run\n"));
  EXPECT_FALSE(fs::exists(folder + "/index.html"));
}

TEST_F(Assess, DoesNotOverwriteACaseThatWasChangedByHand)
{
  const std::string path = folder + "/example-2020.03-v1/case.toml";
  succeeded(test::terp(assess_command(folder, {example}, {"--estimate"})));
  std::ofstream(path, std::ios::app) << "# by hand\n";
  const Finished other = test::terp(assess_command(folder, {example}, {"--estimate", "--strength", "mean"}));
  EXPECT_THAT(other.out, HasSubstr("was changed by hand, and the file or the options changed, too"));
  EXPECT_THAT(text_of(path), HasSubstr("# by hand"));
  succeeded(test::terp(assess_command(folder, {example}, {"--estimate", "--strength", "mean", "--force"})));
  EXPECT_THAT(text_of(path), testing::Not(HasSubstr("# by hand")));
}

TEST_F(Assess, KeepsACaseThatWasChangedByHandAfterItWasSolvedToo)
{
  const std::string section = folder + "/example-2020.03-v1";
  succeeded(test::terp(assess_command(folder, {example}, {"--estimate"})));
  std::ofstream(section + "/case.toml", std::ios::app) << "# by hand\n";
  succeeded(test::terp(assess_command(folder, {example})));
  const Finished other = test::terp(assess_command(folder, {example}, {"--strength", "mean"}));
  EXPECT_EQ(other.status, 3);
  EXPECT_THAT(other.out, HasSubstr("case.toml was changed by hand, and the file or the options changed, too"));
  EXPECT_EQ(reach_in(folder)["sections"][0]["state"], "refused");
  EXPECT_THAT(text_of(section + "/case.toml"), HasSubstr("# by hand"));

  fs::remove(section + "/section.json");  // nothing is known of the case that is there
  EXPECT_THAT(test::terp(assess_command(folder, {example})).out, HasSubstr("case.toml is not as terp wrote it"));
  EXPECT_THAT(text_of(section + "/case.toml"), HasSubstr("# by hand"));
}

TEST_F(Assess, DoesNotHoldAChangedCaseAndSaysThatItsTriggerWasNotApplied)
{
  const std::string section = folder + "/berm-fragility-2023";
  const std::vector<std::string> trigger{"--trigger", "strength=1.3"};
  succeeded(test::terp(assess_command(folder, {berm}, {"--estimate", trigger[0], trigger[1]})));
  std::ofstream(section + "/case.toml", std::ios::app) << "# by hand\n";
  EXPECT_EQ(test::terp(assess_command(folder, {berm}, trigger)).status, 3);
  EXPECT_THAT(text_of(section + "/case.toml"), HasSubstr("# by hand"));
  const auto record = reach_in(folder)["sections"][0];
  EXPECT_THAT(record["fault"], testing::StartsWith("no equilibrium"));
  EXPECT_THAT(record["fault"].get<std::string>(),
      HasSubstr("The case was changed by hand, so it is not imported anew with held soil."));
  EXPECT_EQ(record["ignored"],
      "--trigger strength=1.3 was not applied: the case was changed by hand, and is solved as it stands; --force "
      "imports it anew");
}

TEST_F(Assess, KnowsItsOwnCaseHoweverItsFolderIsSpelled)
{
  const std::string section = folder + "/tutorial-2023";
  const std::string tutorial = source_path("tests/import/dstability/samples/tutorial-2023.stix");  // a case with tables
  succeeded(test::terp(assess_command(folder, {tutorial}, {"--estimate"})));
  const auto imported = record_in(section);
  EXPECT_GT(imported["files"].size(), 1u);
  succeeded(test::terp(assess_command(scratch.path() + "/./reach", {tutorial}, {"--estimate", "--stability"})));
  EXPECT_NE(record_in(section)["question"], imported["question"]);
  EXPECT_EQ(record_in(section)["case_found"], imported["case_found"]);

  auto killed = imported;  // after it had noted the files that it writes, and had written the case
  killed["files_next"] = killed["files"];
  killed["files"]["case.toml"] = "1";
  std::ofstream(section + "/section.json") << killed.dump();
  succeeded(test::terp(assess_command(folder, {tutorial}, {"--estimate"})));
  EXPECT_EQ(record_in(section)["files"], imported["files"]);
  EXPECT_TRUE(record_in(section)["files_next"].empty());
  killed["files_next"].clear();
  std::ofstream(section + "/section.json") << killed.dump();
  EXPECT_THAT(test::terp(assess_command(folder, {tutorial}, {"--estimate", "--stability"})).out,
      HasSubstr("was changed by hand"));
}

TEST_F(Assess, HoldsOnlySoilThatSlidesAsItIsDrawn)
{
  succeeded(test::terp(assess_command(folder, {example}, {"--estimate"})));
  replace_in(folder + "/example-2020.03-v1/case.toml", "[initial]\n", "[initial]\nmax_steps = 20\n");
  EXPECT_EQ(test::terp(assess_command(folder, {example})).status, 3);
  const auto record = reach_in(folder)["sections"][0];
  EXPECT_EQ(record["state"], "failed");
  EXPECT_THAT(record["fault"], StartsWith("no equilibrium: after 20 steps"));
  EXPECT_THAT(record["fault"], Not(HasSubstr("with held soil")));  // nothing is known of it
}

TEST_F(Assess, TakesNoRunOfAnOlderCaseForThatOfTheCase)
{
  const std::string section = folder + "/example-2020.03-v1";
  succeeded(test::terp(assess_command(folder, {example})));
  EXPECT_EQ(error_with(2, test::terp(assess_command(folder, {example}, {"--estimate", "--strength", "mean"}))),
      "error: " + section +
          " has a result of another file, other options or another build of terp\n  --estimate leaves it as it is. "
          "Choose another folder: -o FOLDER. --force replaces the case; the same command without --estimate solves it "
          "anew.\n");
  EXPECT_TRUE(fs::exists(section + "/run/summary.json") && fs::exists(folder + "/index.html"));
  std::ofstream(section + "/case.toml", std::ios::app) << "# by hand\n";
  succeeded(test::terp(assess_command(folder, {example}, {"--estimate"})));
  EXPECT_TRUE(fs::exists(section + "/run/summary.json"));
  for (const char* file : {"/index.html", "/reach.csv", "/reach.json"}) EXPECT_FALSE(fs::exists(folder + file)) << file;
  {
    const FolderLock other(section + "/run");
    EXPECT_EQ(test::terp(assess_command(folder, {example})).status, 3);
    EXPECT_THAT(reach_in(folder)["sections"][0]["fault"], testing::StartsWith("another terp is writing to the run"));
  }
  succeeded(test::terp(assess_command(folder, {example})));
  EXPECT_THAT(text_of(section + "/run/case.toml"), HasSubstr("# by hand"));

  std::ofstream(section + "/run/summary.json") << "{";  // a result that is damaged is made again
  EXPECT_THAT(succeeded(test::terp(assess_command(folder, {example}))).out, testing::Not(HasSubstr("kept")));
}

TEST_F(Assess, IsStoppedByNoBadFile)
{
  std::vector<std::string> files;
  for (const char* name : {"d\xE9.stix", "reach.csv.stix", "c.stix"}) {
    files.push_back(scratch.path() + "/" + name);
    fs::copy_file(nothing, files.back());
  }
  fs::create_directories(folder);
  std::ofstream(folder + "/c") << "no folder\n";
  files.push_back(scratch.path() + "/missing.stix");
  error_with(3, test::terp(assess_command(folder, files)));
  const auto sections = reach_in(folder)["sections"];
  EXPECT_EQ(sections[2]["state"], "failed");
  EXPECT_EQ(sections[3]["state"], "refused");
  EXPECT_THAT(sections[3]["fault"], HasSubstr("missing.stix"));
  EXPECT_EQ(sections[0]["file"], scratch.path() + "/d?.stix");
  EXPECT_EQ(sections[0]["state"], "refused");
  EXPECT_EQ(sections[1]["name"], "reach.csv_2");
  EXPECT_THAT(text_of(folder + "/reach.csv"), testing::StartsWith("section,file,"));
  EXPECT_THAT(sections[2]["fault"], testing::StartsWith("its process ended with status 1 during: import"));
}

TEST_F(Assess, AReportInAnotherLanguageIsMadeAnew)
{
  const std::string section = folder + "/example-2020.03-v1";
  succeeded(test::terp(assess_command(folder, {example})));
  const std::string ledger = text_of(section + "/run/ledger.csv"), english = text_of(section + "/run/report.html");
  EXPECT_THAT(test::terp(assess_command(folder, {example}, {"--language", "nl"})).out, testing::Not(HasSubstr("kept")));
  EXPECT_NE(text_of(section + "/run/report.html"), english);
  EXPECT_EQ(text_of(section + "/run/ledger.csv"), ledger);
  std::string record = text_of(section + "/section.json");
  const std::size_t at = record.find("\"program\": \"") + 11;
  record[at] = record[at] == '0' ? '1' : '0';  // of another program
  std::ofstream(section + "/section.json") << record;
  EXPECT_THAT(test::terp(assess_command(folder, {example}, {"--language", "nl"})).out, testing::Not(HasSubstr("kept")));
  EXPECT_THAT(text_of(section + "/log.txt"), HasSubstr("report\n"));
  EXPECT_THAT(test::terp(assess_command(folder, {example}, {"--language", "nl"})).out, HasSubstr("kept"));
}

}  // namespace assess_test
