#include "io/results/run_results.hpp"
#include "io/files/checkpoint.hpp"
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

TEST_F(RunResultsTest, WhoseTableWasAlteredBeforeItsNewestCheckpointIsRefused)
{
  write_run(folder, [](Summary& s) { s.dt = 0.001; });
  const std::string path = folder + "/history.csv", head = header_of(*history_table());
  std::string table = head + '\n';
  for (int k = 0; k <= 25; ++k) table += csv_lines(sample_history(0.01 * k));
  write_file_atomically(path, table);
  StateImage image = sample_image(5);
  image.time = 0.25;
  const std::string tables = table_line("history.csv", read_part_until(path, head, image.time).checksum);
  CheckpointWriter(folder + '/' + checkpoint_file(5), {}, tables).append(image);
  EXPECT_EQ(file_error_of([&] { read_run(folder); }), "");
  std::string altered = table;
  altered.replace(altered.find("\n0.1,A,7,1.5"), 12, "\n0.1,A,7,1.6");
  write_file_atomically(path, altered);
  EXPECT_EQ(file_error_of([&] { read_run(folder); }),
      path +
          ": this is not what the run wrote: rows up to t = 0.25 s were altered\n  Copy the folder again, or solve the "
          "case again.");
  write_file_atomically(path, table + csv_lines(sample_history(0.26)));  // later rows: the run goes on
  EXPECT_EQ(file_error_of([&] { read_run(folder); }), "");
  std::filesystem::remove(path);
  EXPECT_EQ(file_error_of([&] { read_run(folder); }),
      path + ": it is missing, and the run wrote it\n  Copy the folder again, or solve the case again.");
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
