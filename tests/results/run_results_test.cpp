// A run folder as a whole.
#include "results/run_results.hpp"

#include "results/runs.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::file_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(RunResults, HoldsWhatTheWritersWrote)
{
  const test::ScratchFolder scratch;
  const RunResults run = read_run(test::write_run(scratch.path() + "/model_2_gp"));
  EXPECT_EQ(run.name, "model_2_gp");
  EXPECT_THAT(run.case_toml, HasSubstr("su_peak"));
  EXPECT_EQ(run.summary.values.front_x, 13.0);
  EXPECT_EQ(run.ledger.n_rows(), 2);
  EXPECT_EQ(run.history.size(), 2);
  EXPECT_EQ(run.frames().times().size(), 3);
}

TEST(RunResults, SaysWhichFileIsMissingAndWhatToDo)
{
  const test::ScratchFolder scratch;
  EXPECT_EQ(file_error_of([&] { read_run(scratch.path() + "/none"); }), scratch.path() + "/none: no such run folder");
  EXPECT_THAT(file_error_of([&] { read_run(scratch.path()); }),
      testing::AllOf(HasSubstr("it has no case.toml"), HasSubstr("Give the folder that `terp run` wrote")));
  const std::string folder = test::write_run(scratch.path() + "/run");
  std::filesystem::remove(folder + "/results.vtkhdf");
  EXPECT_THAT(file_error_of([&] { read_run(folder); }), HasSubstr("it has no results.vtkhdf"));
}

TEST(RunResults, DoesWithoutTables)
{
  const test::ScratchFolder scratch;
  const std::string folder = test::write_run(scratch.path() + "/run");
  std::filesystem::remove(folder + "/history.csv");
  std::filesystem::remove(folder + "/ledger.csv");
  EXPECT_EQ(read_run(folder).ledger.n_rows(), 0);
}

TEST(RunResults, ALedgerThatEndsBeforeTheRunIsRefused)
{
  const test::ScratchFolder scratch;
  const std::string folder = test::write_run(scratch.path() + "/run", [](Summary& s) { s.n_steps += 1; });
  EXPECT_THROW(read_run(folder), FileError);
}

TEST(DistinctNames, AreAsMuchOfThePathsAsTellsThemApart)
{
  EXPECT_THAT(distinct_names({"runs/model_2/"}), ElementsAre("model_2"));
  EXPECT_THAT(distinct_names({"runs/mixed", "runs/gp"}), ElementsAre("mixed", "gp"));
  EXPECT_THAT(distinct_names({"a/model_2", "b/model_2"}), ElementsAre("a/model_2", "b/model_2"));
}

}  // namespace
}  // namespace terp
