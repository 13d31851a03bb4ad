#include "io/results/run_results.hpp"
#include "io/results/runs.hpp"
#include "run/report/history.hpp"

namespace run_results_test {

struct RunResultsTest : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
};

TEST_F(RunResultsTest, HoldsWhatTheWritersWrote)
{
  const RunResults run = read_run(write_run(scratch.path() + "/model_2_gp"));
  EXPECT_EQ(run.name, "model_2_gp");
  EXPECT_THAT(run.case_toml, HasSubstr("su_peak"));
  EXPECT_EQ(run.summary.values.front_x, 13.0);
  EXPECT_EQ(run.ledger.n_rows(), 2);
  EXPECT_EQ(run.history.size(), 2);
  EXPECT_EQ(run.frames().times().size(), 3);
}

TEST_F(RunResultsTest, SaysWhichFileIsMissingAndWhatToDo)
{
  EXPECT_EQ(file_error_of([&] { read_run(folder); }), folder + ": no such run folder");
  EXPECT_THAT(file_error_of([&] { read_run(scratch.path()); }),
      AllOf(HasSubstr("it has no case.toml"), HasSubstr("Give the folder that `terp run` wrote")));
  write_run(folder);
  std::filesystem::remove_all(folder + "/frames");
  EXPECT_THAT(file_error_of([&] { read_run(folder); }), HasSubstr("it has no frames"));
}

TEST_F(RunResultsTest, OfAnEarlierTerpAreRefusedWithTheVersionOfTheirFormat)
{
  write_run(folder);
  write_file_atomically(folder + "/results.vtkhdf", "");
  EXPECT_THAT(file_error_of([&] { read_run(folder); }),
      AllOf(HasSubstr("an earlier terp wrote this run, with all frames in one file, results.vtkhdf (VTKHDF 2.0)"),
          HasSubstr("one file per frame (VTKHDF 1.0)")));
}

TEST_F(RunResultsTest, AHistoryThatWasDoubledCutOrHasAGapIsRefused)
{
  write_run(folder, [](Summary& s) { s.dt = 0.001; });
  const std::string path = folder + "/history.csv", head = header_of(*history_table()) + '\n';
  std::string rows;
  for (int k = 0; k <= 25; ++k) rows += csv_lines(sample_history(0.01 * k));
  const auto error_with = [&](const std::string& text) {
    write_file_atomically(path, head + text);
    return file_error_of([&] { read_run(folder); });
  };
  EXPECT_EQ(error_with(rows), "");
  EXPECT_THAT(error_with(rows + rows), StartsWith(path + ": point A: the row of t = 0 s follows that of 0.25 s"));
  EXPECT_THAT(error_with(rows.substr(0, rows.find("\n0.13,") + 1)),
      StartsWith(path + ": point A: it ends at t = 0.12 s, the run at 0.25 s"));
  std::string gap = rows;
  gap.erase(gap.find("\n0.05,"), gap.find("\n0.07,") - gap.find("\n0.05,"));
  EXPECT_THAT(error_with(gap), HasSubstr("point A: rows between t = 0.04 s and 0.07 s are missing\n  The table was"));
  EXPECT_THAT(error_with(rows.substr(0, rows.rfind("0.25,B"))), HasSubstr("point B: it ends at t = 0.24 s"));
}

TEST_F(RunResultsTest, WhoseFilesWereAlteredAreRefused)
{
  write_run(folder);
  const auto path = [&](std::string_view name) { return path_in(folder, name); };
  const std::string ledger = read_file(path(ledger_file)), half = ledger.substr(0, ledger.size() / 2);
  const auto write_summary_of = [&](bool finished) {
    const std::string text = finished ? ledger : half;
    write_summary(path(summary_file), read_summary(path(summary_file)).values, finished,
        {"model_2", read_file(path(case_file))},
        {{std::string(ledger_file), std::ssize(text), digits_of(text)}, {"loads.csv", 0, digits_of("")}});
  };
  write_file_atomically(path("loads.csv"), "");
  write_summary_of(true);
  EXPECT_EQ(file_error_of([&] { read_run(folder); }), "");
  const auto error_with = [&](std::string_view name, const std::string& text) {
    const std::string before = read_file(path(name));
    write_file_atomically(path(name), text);
    const std::string error = file_error_of([&] { read_run(folder); });
    write_file_atomically(path(name), before);
    return error;
  };
  const std::string cure = "\n  Put a copy of it back, or solve the case again.";
  const auto altered = [&](std::string_view name) {
    return path(name) + ": this is not what the run wrote: it was altered, doubled or cut off" + cure;
  };
  EXPECT_EQ(error_with(ledger_file, ledger + ledger), altered(ledger_file));
  EXPECT_EQ(error_with("loads.csv", "time\n"), altered("loads.csv"));
  EXPECT_EQ(error_with(case_file, read_file(path(case_file)) + "# a word\n"),
      path(case_file) + ": this is not the case that was solved: it was altered" + cure);
  std::string summary = read_file(path(summary_file));
  summary.replace(summary.find("13.0"), 4, "14.0");
  EXPECT_THAT(error_with(summary_file, summary), StartsWith(path(summary_file) + ": this is not what the run wrote"));
  std::filesystem::remove(path("loads.csv"));
  EXPECT_EQ(
      file_error_of([&] { read_run(folder); }), path("loads.csv") + ": it is missing, and the run wrote it" + cure);
  write_file_atomically(path("loads.csv"), "");
  write_summary_of(false);  // the run goes on: later rows are not known
  EXPECT_EQ(file_error_of([&] { read_run(folder); }), "");
  EXPECT_EQ(error_with(ledger_file, "x" + ledger), altered(ledger_file));
}

TEST_F(RunResultsTest, DoesWithoutTables)
{
  write_run(folder);
  std::filesystem::remove(folder + "/history.csv");
  std::filesystem::remove(folder + "/ledger.csv");
  EXPECT_EQ(read_run(folder).ledger.n_rows(), 0);
}

TEST_F(RunResultsTest, ALedgerThatEndsBeforeTheRunIsRefused)
{
  write_run(folder, [](Summary& s) { s.n_steps += 1; });
  EXPECT_THROW(read_run(folder), FileError);
}

TEST(DistinctNames, AreAsMuchOfThePathsAsTellsThemApart)
{
  EXPECT_THAT(distinct_names({"runs/model_2/"}), ElementsAre("model_2"));
  EXPECT_THAT(distinct_names({"runs/mixed", "runs/gp"}), ElementsAre("mixed", "gp"));
  EXPECT_THAT(distinct_names({"a/model_2", "b/model_2"}), ElementsAre("a/model_2", "b/model_2"));
}

}  // namespace run_results_test
