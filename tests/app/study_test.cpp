// terp study, as a user runs it.
#include "../study/samples.hpp"
#include "output/run_folder.hpp"
#include "study/study_folder.hpp"
#include "support/process.hpp"
#include "support/test.hpp"

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

namespace study_test {

TEST(StudyCommand, ChecksRunsAndReports)
{
  const ScratchFolder folder;
  const std::string study = write_study(folder.path(), column_study);
  const Finished check = test::terp({"study", "check", study}, folder.path());
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_THAT(
      check.out, HasSubstr("  random         material.clay.su_peak: lognormal, 5 % 3941, 50 % 7428, 95 % 1.4e+04\n"));
  EXPECT_THAT(check.out, HasSubstr("  realisations   12, Monte Carlo\n"));
  EXPECT_THAT(check.out, HasSubstr("nothing was run\n"));
  make_folder(folder.path() + "/runs/demo");
  EXPECT_THAT(test::terp({"study", "report", study}, folder.path()).err, HasSubstr("there are no results"));
  EXPECT_TRUE(names_in(folder.path() + "/runs/demo").empty()) << "and none of its own";
  const Finished run = test::terp({"study", "run", study, "-j", "2"}, folder.path());
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("  probabilities with 95 % bounds\n"));
  EXPECT_THAT(run.out, HasSubstr("a slide: 1 m^2 or more moved by more than 0.3 m\n"));
  EXPECT_THAT(names_in(folder.path() + "/runs/demo"), ElementsAre("case.toml", "locks", "part_1_of_1.rows",
                                                          "report.html", "results.csv", "results.json", "study.toml"));
  const Finished again = test::terp({"study", "report", "runs/demo"}, folder.path());
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("12 realisations, 12 solved, 0 failed"));
  EXPECT_THAT(test::terp({"study", "status", study}, folder.path()).out, HasSubstr("P(I)"));
}

TEST(StudyCommand, ARealisationIsKeptWithTheSameResults)
{
  const ScratchFolder folder;
  const std::string study = write_study(folder.path(), field_study);
  ASSERT_EQ(test::terp({"study", "run", study, "-q"}, folder.path()).status, 0);
  const Finished keep = test::terp({"study", "run", study, "--keep", "4", "-j", "2"}, folder.path());
  EXPECT_EQ(keep.status, 0) << keep.err;
  EXPECT_THAT(keep.out, HasSubstr("realisation 4 has the results of the store, to the bit\n"));
  EXPECT_THAT(text_of(folder.path() + "/runs/demo/kept/4/case.toml"), HasSubstr("realisation = 4"));
  EXPECT_THAT(test::terp({"study", "run", study, "--keep", "6"}, folder.path()).err, HasSubstr("numbered 0 to 5"));
}

TEST(StudyCommand, ARealisationThatEndedWithItsEventsIsKeptToTheEnd)
{
  const ScratchFolder folder;
  const std::string text = changed(column_study, "displacement = 0.3", "displacement = 0.3\nends_run = true");
  const std::string study = write_study(folder.path(), text);
  EXPECT_THAT(test::terp({"study", "check", study}, folder.path()).out,
      HasSubstr("  ends           a realisation with its events"));
  ASSERT_EQ(test::terp({"study", "run", study, "-q"}, folder.path()).status, 0);
  const Realisations rows = read_store(open_study(study), folder.path() + "/runs/demo").rows;
  const auto ended = std::ranges::find_if(rows, [](const auto& row) {
    return row.second.solved() && std::isnan(row.second.outcomes[outcome_number("slide_volume")]);
  });
  ASSERT_NE(ended, rows.end());
  const std::string number = std::to_string(ended->first);
  const Finished keep = test::terp({"study", "run", study, "--keep", number}, folder.path());
  EXPECT_THAT(keep.out, HasSubstr("realisation " + number + " has the results of the store, to the bit\n"));
  const auto json = nlohmann::json::parse(text_of(folder.path() + "/runs/demo/kept/" + number + "/summary.json"));
  EXPECT_GT(json["steps"].get<Real>() * json["dt"].get<Real>(), 0.79) << "to the end of the case";
}

TEST(StudyCommand, ARealisationWithOtherResultsThanInTheStoreIsToldAndNotKept)
{
  const ScratchFolder folder;
  const std::string study = write_study(folder.path(), field_study),
                    mark = folder.path() + "/runs/demo/kept/4/of_study.txt";
  ASSERT_EQ(test::terp({"study", "run", study, "-q"}, folder.path()).status, 0);
  ASSERT_EQ(test::terp({"study", "run", study, "--keep", "4", "-q"}, folder.path()).status, 0);
  EXPECT_TRUE(std::filesystem::exists(mark));
  const Study read = open_study(study);
  Realisations rows = read_store(read, folder.path() + "/runs/demo").rows;
  rows.at(4).outcomes[outcome_number("slide_volume")] += 1e-9;
  std::filesystem::remove(folder.path() + "/runs/demo/part_1_of_1.rows");
  StoreWriter store(read, folder.path() + "/runs/demo", {});
  for (const auto& [number, r] : rows) store.append(r);
  const Finished keep = test::terp({"study", "run", study, "--keep", "4", "-q"}, folder.path());
  EXPECT_EQ(keep.status, 1);
  EXPECT_THAT(keep.err, HasSubstr("realisation 4 has other results than in the store: slide_volume\n"));
  EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST(StudyCommand, IsKilledAgainAndAgainAndEndsInTheSameTable)
{
  const ScratchFolder folder;
  const std::string longer = changed(column_study, "number = 12", "number = 200"),
                    study = write_study(folder.path(), longer, changed(column_case, "end = 0.8", "end = 3.0"));
  ASSERT_EQ(test::terp({"study", "run", study, "-q", "-j", "1", "-o", "whole"}, folder.path()).status, 0);
  const std::string table = text_of(folder.path() + "/whole/results.csv");
  int kills = 0;
  for (int k = 0; k < 8; ++k) {
    Process process({"study", "run", study, "-q", "-j", std::to_string(1 + k % 4), "-o", "killed"}, folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(60 + 20 * k));
    process.send(SIGKILL);
    kills += process.wait().status == 128 + SIGKILL;
  }
  EXPECT_GT(kills, 0);
  ASSERT_EQ(test::terp({"study", "run", study, "-q", "-j", "2", "-o", "killed"}, folder.path()).status, 0);
  EXPECT_EQ(text_of(folder.path() + "/killed/results.csv"), table);
}

TEST(StudyCommand, TwoLevelsAreCheckedKilledKeptAndEndInTheSameTable)
{
  const ScratchFolder folder;
  const std::string text = changed(changed(column_study, "kind = \"monte_carlo\"",
                                       "kind = \"multilevel\"\ncoarse = { \"mesh.cell\" = 1.0 }\npairs = 10"),
                        "number = 12", "number = 100"),
                    study = write_study(folder.path(), "set = { \"mesh.cell\" = 0.5 }\n" + text);
  const Finished check = test::terp({"study", "check", study}, folder.path());
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_THAT(check.out, AllOf(HasSubstr("  realisations   110, coarse realisations, corrected by pairs\n"),
                             HasSubstr("  of these       100 coarse, of which the first 10 are solved fine too\n"),
                             ContainsRegex("expected time  at most .* each fine, .* each coarse, at most .* in all\n"),
                             HasSubstr("  realisation 0, coarse  can be solved: 32 material points\n"),
                             HasSubstr("  realisation 1, fine  can be solved: 128 material points\n")));
  ASSERT_EQ(test::terp({"study", "run", study, "-q", "-j", "1", "-o", "whole"}, folder.path()).status, 0);
  const std::string table = text_of(folder.path() + "/whole/results.csv");
  int kills = 0;
  for (int k = 0; k < 4; ++k) {
    Process process({"study", "run", study, "-q", "-j", std::to_string(1 + k % 2), "-o", "killed"}, folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(60 + 20 * k));
    process.send(SIGKILL);
    kills += process.wait().status == 128 + SIGKILL;
  }
  EXPECT_GT(kills, 0);
  const Finished run = test::terp({"study", "run", study, "-j", "2", "-o", "killed"}, folder.path());
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(text_of(folder.path() + "/killed/results.csv"), table);
  EXPECT_THAT(
      run.out, AllOf(HasSubstr("110 realisations, 110 solved, 0 failed"), HasSubstr(" of 10 pairs  a slide: ")));
  for (const char* number : {"2", "3", "109"}) {
    const Finished keep =
        test::terp({"study", "run", study, "--keep", number, "-j", "1", "-o", "killed"}, folder.path());
    EXPECT_THAT(keep.out, HasSubstr("has the results of the store, to the bit\n")) << number << keep.err;
  }
}

TEST(StudyCommand, BeginsAnewOnlyWhereNobodyElseWrites)
{
  const ScratchFolder folder;
  const std::string study = write_study(folder.path(), column_study);
  ASSERT_EQ(test::terp({"study", "run", study, "-q"}, folder.path()).status, 0);
  const std::string rows = folder.path() + "/runs/demo/part_1_of_1.rows", before = text_of(rows);
  {
    const FolderLock lock(folder.path() + "/runs/demo/locks/part_1_of_1");
    const Finished forced = test::terp({"study", "run", study, "-q", "--force"}, folder.path());
    EXPECT_EQ(forced.status, 1);
    EXPECT_THAT(forced.err, HasSubstr("another terp is writing to the run folder runs/demo/locks/part_1_of_1"));
  }
  EXPECT_EQ(text_of(rows), before) << "the store of a study that runs stays";
  EXPECT_EQ(test::terp({"study", "run", study, "--force", "--part", "2/3"}, folder.path()).err,
      "error: --force with --part 2/3: a part does not begin anew, as it would remove what others solved\n"
      "  Remove the folder once, before the parts begin: rm -r runs/demo\n");
  EXPECT_EQ(test::terp({"study", "run", "runs/demo", "-q", "--force"}, folder.path()).status, 0);
  EXPECT_THAT(names_in(folder.path() + "/runs/demo"), ElementsAre("case.toml", "locks", "part_1_of_1.rows",
                                                          "report.html", "results.csv", "results.json", "study.toml"));
  const Finished here = test::terp({"study", "run", study, "-q", "--force", "-o", "."}, folder.path());
  EXPECT_EQ(here.status, 1);
  EXPECT_THAT(here.err, HasSubstr("the folder holds the study file"));
  EXPECT_EQ(text_of(study), column_study);
}

TEST(StudyCommand, RefusesWrongWords)
{
  const ScratchFolder folder;
  const std::string study = write_study(folder.path(), column_study);
  EXPECT_EQ(test::terp({"study", "run", study, "--part", "3/2"}, folder.path()).err,
      "error: --part 3/2: a part is K/N, K from 1 to N\n  As in --part 3/100, of the third of a hundred tasks.\n");
  EXPECT_THAT(test::terp({"study", "go", study}).err, HasSubstr("ACTION: go not in {check,sample,run,status,report}"));
  EXPECT_THAT(test::terp({"study", "run", "none.toml"}).err, HasSubstr("none.toml: there is no such file"));
  EXPECT_THAT(
      test::terp({"study", "report", study}, folder.path()).err, HasSubstr("there are no results of this study"));
  EXPECT_EQ(test::terp({"study", "run", study, "-q", "--part", "2/3"}, folder.path()).status, 0);
  EXPECT_THAT(test::terp({"study", "status", study}, folder.path()).out, HasSubstr("0 realisations"));
}

}  // namespace study_test
