#include "batch/samples.hpp"
#include "io/files/run_folder.hpp"
#include "batch/study_folder.hpp"
#include "support/process.hpp"
#include "support/scratch.hpp"

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

namespace study_test {

struct StudyCommand : ScratchTest {
  /// Begins the study n times in the folder `killed`, on 1 to `most` threads, and kills it a moment later.
  void kill_often(const std::string& study, int n, int most) const
  {
    int kills = 0;
    for (int k = 0; k < n; ++k) {
      Process process({"study", "run", study, "-q", "-j", std::to_string(1 + k % most), "-o", "killed"}, folder);
      std::this_thread::sleep_for(std::chrono::milliseconds(60 + 20 * k));
      process.send(SIGKILL);
      kills += process.wait().status == 128 + SIGKILL;
    }
    EXPECT_GT(kills, 0);
  }
};

TEST_F(StudyCommand, ChecksRunsAndReports)
{
  const std::string study = write_study(folder, column_study);
  const Finished check = succeeded(test::terp({"study", "check", study}, folder));
  EXPECT_THAT(
      check.out, HasSubstr("  random         material.clay.su_peak: lognormal, 5 % 3941, 50 % 7428, 95 % 1.4e+04\n"));
  EXPECT_THAT(check.out, AllOf(HasSubstr("  realisations   12, Monte Carlo\n"), HasSubstr("nothing was run\n")));
  make_folder(folder + "/runs/demo");
  EXPECT_THAT(test::terp({"study", "report", study}, folder).err, HasSubstr("there are no results"));
  EXPECT_TRUE(names_in(folder + "/runs/demo").empty()) << "and none of its own";
  const Finished run = succeeded(test::terp({"study", "run", study, "-j", "2"}, folder));
  EXPECT_THAT(run.out, HasSubstr("  probabilities with 95 % bounds\n"));
  EXPECT_THAT(run.out, HasSubstr("a slide: 1 m^2 or more moved by more than 0.3 m\n"));
  EXPECT_THAT(names_in(folder + "/runs/demo"), ElementsAre("case.toml", "failure_path.csv", "locks", "part_1_of_1.rows",
                                                   "report.html", "results.csv", "results.json", "study.toml"));
  EXPECT_THAT(succeeded(test::terp({"study", "report", "runs/demo"}, folder)).out,
      HasSubstr("12 realisations, 12 solved, 0 failed"));
  EXPECT_THAT(test::terp({"study", "status", study}, folder).out, HasSubstr("P(I)"));
}

TEST_F(StudyCommand, ARealisationIsKeptWithTheSameResults)
{
  const std::string study = write_study(folder, field_study);
  succeeded(test::terp({"study", "run", study, "-q"}, folder));
  EXPECT_THAT(succeeded(test::terp({"study", "run", study, "--keep", "4", "-j", "2"}, folder)).out,
      HasSubstr("realisation 4 has the results of the store, to the bit\n"));
  EXPECT_THAT(text_of(folder + "/runs/demo/kept/4/case.toml"), HasSubstr("realisation = 4"));
  EXPECT_THAT(test::terp({"study", "run", study, "--keep", "6"}, folder).err, HasSubstr("numbered 0 to 5"));
}

TEST_F(StudyCommand, ARealisationWithOtherResultsThanInTheStoreIsToldAndNotKept)
{
  const std::string study = write_study(folder, field_study), mark = folder + "/runs/demo/kept/4/of_study.txt";
  succeeded(test::terp({"study", "run", study, "-q"}, folder));
  succeeded(test::terp({"study", "run", study, "--keep", "4", "-q"}, folder));
  EXPECT_TRUE(std::filesystem::exists(mark));
  const Study read = open_study(study);
  Realisations rows = read_store(read, folder + "/runs/demo").rows;
  rows.at(4).outcomes[outcome_number("slide_volume")] += 1e-9;
  std::filesystem::remove(folder + "/runs/demo/part_1_of_1.rows");
  StoreWriter store(read, folder + "/runs/demo", {});
  for (const auto& [number, r] : rows) store.append(r);
  EXPECT_THAT(error_with(1, test::terp({"study", "run", study, "--keep", "4", "-q"}, folder)),
      HasSubstr("realisation 4 has other results than in the store: slide_volume\n"));
  EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST_F(StudyCommand, IsKilledAgainAndAgainAndEndsInTheSameTable)
{
  const std::string longer = changed(column_study, "number = 12", "number = 200"),
                    study = write_study(folder, longer, changed(column_case, "end = 0.8", "end = 3.0"));
  succeeded(test::terp({"study", "run", study, "-q", "-j", "1", "-o", "whole"}, folder));
  const std::string table = text_of(folder + "/whole/results.csv");
  kill_often(study, 8, 4);
  succeeded(test::terp({"study", "run", study, "-q", "-j", "2", "-o", "killed"}, folder));
  EXPECT_EQ(text_of(folder + "/killed/results.csv"), table);
}

TEST_F(StudyCommand, TwoLevelsAreCheckedKilledKeptAndEndInTheSameTable)
{
  const std::string text = changed(changed(column_study, "kind = \"monte_carlo\"",
                                       "kind = \"multilevel\"\ncoarse = { \"mesh.cell\" = 1.0 }\npairs = 10"),
                        "number = 12", "number = 100"),
                    study = write_study(folder, "set = { \"mesh.cell\" = 0.5 }\n" + text);
  EXPECT_THAT(succeeded(test::terp({"study", "check", study}, folder)).out,
      AllOf(HasSubstr("  realisations   110, coarse realisations, corrected by pairs\n"),
          HasSubstr("  of these       100 coarse, of which the first 10 are solved fine too\n"),
          ContainsRegex("expected time  at most .* each fine, .* each coarse, at most .* in all\n"),
          HasSubstr("  realisation 0, coarse  can be solved: 32 material points\n"),
          HasSubstr("  realisation 1, fine  can be solved: 128 material points\n")));
  succeeded(test::terp({"study", "run", study, "-q", "-j", "1", "-o", "whole"}, folder));
  const std::string table = text_of(folder + "/whole/results.csv");
  kill_often(study, 4, 2);
  const Finished run = succeeded(test::terp({"study", "run", study, "-j", "2", "-o", "killed"}, folder));
  EXPECT_EQ(text_of(folder + "/killed/results.csv"), table);
  EXPECT_THAT(
      run.out, AllOf(HasSubstr("110 realisations, 110 solved, 0 failed"), HasSubstr(" of 10 pairs  a slide: ")));
  for (const char* number : {"2", "3", "109"}) {
    const Finished keep = test::terp({"study", "run", study, "--keep", number, "-j", "1", "-o", "killed"}, folder);
    EXPECT_THAT(keep.out, HasSubstr("has the results of the store, to the bit\n")) << number << keep.err;
  }
}

TEST_F(StudyCommand, BeginsAnewOnlyWhereNobodyElseWrites)
{
  const std::string study = write_study(folder, column_study);
  succeeded(test::terp({"study", "run", study, "-q"}, folder));
  const std::string rows = folder + "/runs/demo/part_1_of_1.rows", before = text_of(rows);
  {
    const FolderLock lock(folder + "/runs/demo/locks/part_1_of_1");
    EXPECT_THAT(error_with(1, test::terp({"study", "run", study, "-q", "--force"}, folder)),
        HasSubstr("another terp is writing to the run folder runs/demo/locks/part_1_of_1"));
  }
  EXPECT_EQ(text_of(rows), before) << "the store of a study that runs stays";
  EXPECT_EQ(test::terp({"study", "run", study, "--force", "--part", "2/3"}, folder).err,
      "error: --force in part 2 of 3: a part does not begin anew, as it would remove what others solved\n"
      "  Remove the folder once, before the parts begin: rm -r runs/demo\n");
  succeeded(test::terp({"study", "run", "runs/demo", "-q", "--force"}, folder));
  EXPECT_THAT(names_in(folder + "/runs/demo"), ElementsAre("case.toml", "failure_path.csv", "locks", "part_1_of_1.rows",
                                                   "report.html", "results.csv", "results.json", "study.toml"));
  EXPECT_THAT(error_with(1, test::terp({"study", "run", study, "-q", "--force", "-o", "."}, folder)),
      HasSubstr("the folder holds the study file"));
  EXPECT_EQ(text_of(study), column_study);
}

TEST_F(StudyCommand, RefusesWrongWords)
{
  const std::string study = write_study(folder, column_study);
  EXPECT_EQ(test::terp({"study", "run", study, "--part", "3/2"}, folder).err,
      "error: --part 3/2: a part is K/N, K from 1 to N\n  As in --part 3/100, of the third of a hundred tasks.\n");
  EXPECT_THAT(test::terp({"study", "go", study}).err, HasSubstr("ACTION: go not in {check,sample,run,status,report}"));
  EXPECT_THAT(test::terp({"study", "run", "none.toml"}).err, HasSubstr("none.toml: there is no such file"));
  EXPECT_THAT(test::terp({"study", "report", study}, folder).err, HasSubstr("there are no results of this study"));
  succeeded(test::terp({"study", "run", study, "-q", "--part", "2/3"}, folder));
  EXPECT_THAT(test::terp({"study", "status", study}, folder).out, HasSubstr("0 realisations"));
}

}  // namespace study_test
