// terp study run as one of several processes: what mpirun, srun and Slurm set, set by the test.
#include "batch/samples.hpp"
#include "io/files/run_folder.hpp"
#include "batch/reliability.hpp"
#include "support/environment.hpp"
#include "support/process.hpp"

#include <fmt/format.h>

#include <csignal>
#include <deque>
#include <thread>

namespace study_run_test {

using Setting = std::map<std::string, std::string>;

constexpr int n_ranks = 4;

Setting of_mpirun(int rank)
{
  return {{"OMPI_COMM_WORLD_RANK", std::to_string(rank)}, {"OMPI_COMM_WORLD_SIZE", std::to_string(n_ranks)}};
}

Setting of_array(int rank)
{
  return {{"SLURM_ARRAY_TASK_ID", std::to_string(10 + 5 * rank)}, {"SLURM_ARRAY_TASK_COUNT", std::to_string(n_ranks)},
      {"SLURM_ARRAY_TASK_MIN", "10"}, {"SLURM_ARRAY_TASK_STEP", "5"}};
}

/// An array of two jobs, each with two ranks of srun.
Setting of_both(int rank)
{
  return {{"SLURM_ARRAY_TASK_ID", std::to_string(rank / 2)}, {"SLURM_ARRAY_TASK_COUNT", "2"},
      {"SLURM_ARRAY_TASK_MIN", "0"}, {"SLURM_PROCID", std::to_string(rank % 2)}, {"SLURM_STEP_NUM_TASKS", "2"}};
}

class Launch {
 public:
  Launch(const std::string& folder, const std::vector<std::string>& words, Setting (*setting)(int) = of_mpirun)
  {
    for (int rank = 0; rank < n_ranks; ++rank) {
      const Setting all = setting(rank);  // a Variable takes no copy of its name
      std::deque<Variable> variables;
      for (const auto& [name, value] : all) variables.emplace_back(name.c_str(), value);
      ranks_.push_back(std::make_unique<Process>(words, folder));
    }
  }
  std::vector<Finished> wait()
  {
    std::vector<Finished> all;
    for (const auto& rank : ranks_) all.push_back(rank->wait());
    return all;
  }
  Process& rank(int k) { return *ranks_[static_cast<std::size_t>(k)]; }

 private:
  std::vector<std::unique_ptr<Process>> ranks_;
};

class StudyRun : public testing::Test {
 protected:
  ScratchFolder scratch_;
  std::string folder = scratch_.path();

  std::string write(const std::string& text, const std::string& column = column_case)
  {
    const std::string path = write_study(folder, text, column);
    succeeded(test::terp({"study", "run", path, "-q", "-j", "2", "-o", "one"}, folder));
    return path;
  }
  std::string of(const std::string& name) const { return text_of(folder + '/' + name); }
};

TEST_F(StudyRun, EachProcessMakesItsPartAndTheLastOneTheTable)
{
  const std::string study = write(column_study);
  const struct {
    Setting (*setting)(int);
    std::set<int> silent;  // another one prints to the same terminal
  } launches[] = {{of_mpirun, {1, 2, 3}}, {of_array, {}}, {of_both, {1, 3}}};
  for (const auto& [setting, silent] : launches) {
    std::filesystem::remove_all(folder + "/ranks");
    const std::vector<Finished> all = Launch(folder, {"study", "run", study, "-o", "ranks"}, setting).wait();
    for (int rank = 0; rank < n_ranks; ++rank) {
      const Finished& one = all[static_cast<std::size_t>(rank)];
      EXPECT_EQ(one.status, 0) << one.err;
      EXPECT_EQ(one.err, "") << rank;
      EXPECT_EQ(one.out.empty(), silent.contains(rank)) << rank << one.out;
    }
    EXPECT_EQ(of("ranks/results.csv"), of("one/results.csv"));
    EXPECT_THAT(names_in(folder + "/ranks"),
        ElementsAre("case.toml", "failure_path.csv", "locks", "part_1_of_4.rows", "part_2_of_4.rows",
            "part_3_of_4.rows", "part_4_of_4.rows", "report.html", "results.csv", "results.json", "study.toml"));
  }
}

TEST_F(StudyRun, AfterAnyKillTheSameCommandGoesOn)
{
  const std::string study =
      write(changed(column_study, "number = 12", "number = 400"), changed(column_case, "end = 0.8", "end = 3.0"));
  const std::vector<std::string> words{"study", "run", study, "-q", "-o", "ranks"};
  {
    Launch launch(folder, words);
    const auto send_after = [&](int rank, std::ptrdiff_t n_rows, int signal) {
      const std::string rows = fmt::format("ranks/part_{}_of_4.rows", rank + 1);
      for (int k = 0; k < 3000 && std::ranges::count(of(rows), '\n') < n_rows; ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      launch.rank(rank).send(signal);
    };
    for (const int rank : {1, 3}) send_after(rank, 3, SIGSTOP);
    for (const int rank : {0, 2}) send_after(rank, 10, SIGKILL);
    EXPECT_THAT(error_with(1, test::terp({"study", "run", study, "-q", "-o", "ranks", "--part", "2/4"}, folder)),
        HasSubstr("another terp is writing to the run folder ranks/locks/part_2_of_4"));
    launch.rank(3).send(SIGTERM);
    for (const int rank : {1, 3}) launch.rank(rank).send(SIGCONT);
    const std::vector<Finished> all = launch.wait();
    EXPECT_EQ(all[1].status, 0) << "a rank that is killed ends no other: " << all[1].err;
    EXPECT_THAT(all[3].err, HasSubstr("stopped; what is solved is kept in ranks. Go on with the same command\n"));
  }
  EXPECT_EQ(of("ranks/results.csv"), "") << "not all is solved";
  const std::string before = of("ranks/part_1_of_4.rows");
  for (const Finished& rank : Launch(folder, words).wait()) EXPECT_EQ(rank.status, 0) << rank.err;
  EXPECT_EQ(of("ranks/results.csv"), of("one/results.csv"));
  EXPECT_THAT(of("ranks/part_1_of_4.rows"), StartsWith(before.substr(0, before.rfind('\n'))))
      << "what was solved is kept";
}

TEST_F(StudyRun, OtherNumbersOfProcessesGoOnWithOneStudy)
{
  const std::string study = write(column_study);
  succeeded(test::terp({"study", "run", study, "-q", "-o", "ranks", "--part", "2/3"}, folder));
  for (const Finished& rank : Launch(folder, {"study", "run", study, "-q", "-o", "ranks"}).wait())
    EXPECT_EQ(rank.status, 0) << rank.err;
  EXPECT_EQ(of("ranks/results.csv"), of("one/results.csv"));
}

TEST_F(StudyRun, RefusesWhatPartsCannotDo)
{
  const std::string study = write_study(folder, column_study);
  EXPECT_EQ(Launch(folder, {"study", "run", study, "--force"}).wait()[2].err,
      "error: --force in part 3 of 4: a part does not begin anew, as it would remove what others solved\n"
      "  Remove the folder once, before the parts begin: rm -r runs/demo\n");
  const Variable task("SLURM_ARRAY_TASK_ID", "9"), count("SLURM_ARRAY_TASK_COUNT", "3");
  EXPECT_EQ(error_with(1, test::terp({"study", "run", study}, folder)),
      "error: SLURM_ARRAY_TASK_ID is 9, of 3 tasks: the array has gaps, and this task has no place in it\n"
      "  Number the tasks evenly, as --array=1-3, or say which part each makes: --part K/N\n");
  EXPECT_FALSE(std::filesystem::exists(folder + "/runs"));
  succeeded(test::terp({"study", "run", study, "-q", "--part", "1/1"}, folder));
}

TEST_F(StudyRun, AMethodThatChoosesItsRealisationsHasNoParts)
{
  if (!has_openturns()) GTEST_SKIP() << "this build has no OpenTURNS";
  const std::string study = write_study(folder, changed(column_study, "kind = \"monte_carlo\"", "kind = \"subset\""));
  EXPECT_EQ(Launch(folder, {"study", "run", study}).wait()[1].err,
      "error: part 2 of 4: `subset` chooses its realisations one after another, so it has no parts\n"
      "  Start one process, without --part, mpirun, srun or an array, on the machine with the most processors.\n");
}

}  // namespace study_run_test
