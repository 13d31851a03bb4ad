// terp study run under a launcher: what mpirun and srun set, set by the test.
#include "../study/samples.hpp"
#include "io/files/run_folder.hpp"
#include "os/instructions.hpp"
#include "support/environment.hpp"
#include "support/process.hpp"

#include <csignal>
#include <thread>

namespace study_run_test {

constexpr int n_ranks = 4;

std::unique_ptr<Process> start_rank(
    int rank, const std::string& folder, const std::vector<std::string>& words, const std::string& launch = "1")
{
  const Variable number("OMPI_COMM_WORLD_RANK", std::to_string(rank)),
      size("OMPI_COMM_WORLD_SIZE", std::to_string(n_ranks)), job("PMIX_NAMESPACE", launch);
  return std::make_unique<Process>(words, folder);
}

class Launch {
 public:
  Launch(const std::string& folder, const std::vector<std::string>& words)
  {
    static int n_launches = 0;
    const std::string launch = std::to_string(++n_launches);
    for (int rank = 0; rank < n_ranks; ++rank) ranks_.push_back(start_rank(rank, folder, words, launch));
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

/// The process that solves for a rank; 0: there is none yet.
pid_t worker_of(const Process& rank)
{
  const std::string pid = std::to_string(rank.pid());
  return std::atoi(text_of("/proc/" + pid + "/task/" + pid + "/children").c_str());
}

/// Waits until the worker of a rank is connected to rank 0. On a busy machine the others begin long before.
bool has_joined(const Process& rank)
{
  for (int k = 0; k < 3000; ++k) {
    if (const pid_t worker = worker_of(rank); worker > 0) {
      std::error_code gone;
      for (const auto& file : std::filesystem::directory_iterator("/proc/" + std::to_string(worker) + "/fd", gone))
        if (std::filesystem::read_symlink(file, gone).string().starts_with("socket:")) return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

struct LongStudy {
  ScratchFolder folder;
  std::string path = write_study(folder.path(), changed(column_study, "number = 12", "number = 400"),
      changed(column_case, "end = 0.8", "end = 3.0"));
  std::string whole;
  LongStudy()
  {
    EXPECT_EQ(test::terp({"study", "run", path, "-q", "-j", "2", "-o", "whole"}, folder.path()).status, 0);
    whole = table("whole");
  }
  std::string table(const std::string& name) const { return text_of(folder.path() + '/' + name + "/results.csv"); }
  std::string rows(const std::string& name) const { return text_of(folder.path() + '/' + name + "/part_1_of_1.rows"); }
  void wait_for_rows(const std::string& name, std::ptrdiff_t n) const
  {
    for (int k = 0; k < 600 && std::ranges::count(rows(name), '\n') < n; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
};

TEST(StudyRun, FourRanksMakeOneTableAndRankZeroSpeaks)
{
  const ScratchFolder folder;
  const std::string study = write_study(folder.path(), column_study);
  succeeded(test::terp({"study", "run", study, "-q", "-o", "one"}, folder.path()));
  const std::vector<Finished> all = Launch(folder.path(), {"study", "run", study}).wait();
  EXPECT_THAT(all[0].out, AllOf(HasSubstr("12 realisations, 12 solved"), HasSubstr("page in runs/demo/report.html")));
  for (int rank = 0; rank < n_ranks; ++rank) {
    EXPECT_EQ(all[static_cast<std::size_t>(rank)].status, 0) << all[static_cast<std::size_t>(rank)].err;
    EXPECT_EQ(all[static_cast<std::size_t>(rank)].err, "") << rank;
    EXPECT_EQ(all[static_cast<std::size_t>(rank)].out.empty(), rank > 0) << rank;
  }
  EXPECT_EQ(text_of(folder.path() + "/runs/demo/results.csv"), text_of(folder.path() + "/one/results.csv"));
  EXPECT_THAT(names_in(folder.path() + "/runs/demo"),
      ElementsAre("case.toml", "locks", "part_1_of_1.rows", "report.html", "results.csv", "results.json", "study.toml"))
      << "one store, whatever the number of ranks";
  Launch status(folder.path(), {"study", "status", study});
  const std::vector<Finished> said = status.wait();
  EXPECT_THAT(said[0].out, HasSubstr("12 realisations"));
  for (int rank = 1; rank < n_ranks; ++rank) EXPECT_EQ(said[static_cast<std::size_t>(rank)].out, "");
}

TEST(StudyRun, AWorkerThatIsKilledLosesItsRealisationAlone)
{
  const LongStudy study;
  Launch launch(study.folder.path(), {"study", "run", study.path, "-q", "-o", "ranks"});
  for (const int rank : {0, 2}) ASSERT_TRUE(has_joined(launch.rank(rank))) << rank;
  study.wait_for_rows("ranks", std::ranges::count(study.rows("ranks"), '\n') + 10);  // so rank 0 has read their hello
  for (const int rank : {0, 2}) ::kill(worker_of(launch.rank(rank)), SIGKILL);
  const std::vector<Finished> all = launch.wait();
  for (const Finished& rank : all) EXPECT_EQ(rank.status, 0) << rank.err;
  EXPECT_THAT(all[0].err, AllOf(ContainsRegex("warning: rank 0 on .* is lost; realisation [0-9]+ goes to another"),
                              ContainsRegex("warning: rank 2 on .* is lost")));
  EXPECT_EQ(all[2].err, "rank 2: its worker was ended by signal 9 (Killed)\n");
  EXPECT_EQ(study.table("ranks"), study.whole);
}

TEST(StudyRun, AfterRankZeroWasKilledTheSameCommandGoesOn)
{
  const LongStudy study;
  const std::vector<std::string> words{"study", "run", study.path, "-q", "-o", "ranks"};
  {
    Launch launch(study.folder.path(), words);
    study.wait_for_rows("ranks", 20);
    launch.rank(0).send(SIGKILL);
    const std::vector<Finished> all = launch.wait();
    for (int rank = 1; rank < n_ranks; ++rank) EXPECT_EQ(all[static_cast<std::size_t>(rank)].status, 0);
  }
  const std::string before = study.rows("ranks");
  EXPECT_EQ(study.table("ranks"), "");
  Launch launch(study.folder.path(), words);
  for (const Finished& rank : launch.wait()) EXPECT_EQ(rank.status, 0) << rank.err;
  EXPECT_EQ(study.table("ranks"), study.whole);
  EXPECT_THAT(study.rows("ranks"), StartsWith(before.substr(0, before.rfind('\n')))) << "what was solved was kept";
}

TEST(StudyRun, AnotherTerpIsRefusedWhileRanksSolve)
{
  const LongStudy study;
  Launch launch(study.folder.path(), {"study", "run", study.path, "-q", "-o", "ranks"});
  study.wait_for_rows("ranks", 10);
  EXPECT_THAT(error_with(1, test::terp({"study", "run", study.path, "-q", "-o", "ranks"}, study.folder.path())),
      HasSubstr("another terp is writing to the run folder ranks/locks/part_1_of_1"));
  launch.rank(0).send(SIGTERM);
  const std::vector<Finished> all = launch.wait();
  EXPECT_EQ(all[0].status, 1);
  EXPECT_THAT(all[0].err, HasSubstr("stopped; what is solved is kept in ranks. Go on with the same command\n"));
  for (int rank = 1; rank < n_ranks; ++rank) EXPECT_EQ(all[static_cast<std::size_t>(rank)].status, 0);
}

TEST(StudyRun, ARankWithOtherBitsDoesNotTakePart)
{
  if (std::ranges::count(instruction_sets(), true, &InstructionSet::offered) < 2 || instructions() == "sse2")
    GTEST_SKIP() << "this machine or build has one set";
  const ScratchFolder folder;
  const std::string study = write_study(folder.path(), column_study);
  const auto rank_0 = start_rank(0, folder.path(), {"study", "run", study, "-q"});
  std::unique_ptr<Process> rank_1;
  {
    const Variable other("TERP_INSTRUCTIONS", "sse2");
    rank_1 = start_rank(1, folder.path(), {"study", "run", study, "-q"});
  }
  const Finished first = rank_0->wait(), second = rank_1->wait();
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(second.status, 0) << "the others go on";
  if (!second.err.empty()) {  // else the study was over before it came
    EXPECT_THAT(first.err, ContainsRegex("warning: rank 1 on .* does not take part: it is build .* of terp with sse2"));
  }
}

TEST(StudyRun, AWrongStudyIsRefusedOnce)
{
  const ScratchFolder folder;
  const std::vector<Finished> all = Launch(folder.path(), {"study", "run", "none.toml"}).wait();
  EXPECT_EQ(all[0].status, 2);
  EXPECT_THAT(all[0].err, HasSubstr("none.toml: there is no such file"));
  for (int rank = 1; rank < n_ranks; ++rank) EXPECT_EQ(all[static_cast<std::size_t>(rank)].err, "") << rank;
}

}  // namespace study_run_test
