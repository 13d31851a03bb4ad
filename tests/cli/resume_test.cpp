#include "cli/same_results.hpp"
#include "io/files/small_disk.hpp"
#include <csignal>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace resume_test {

const std::string last_checkpoint = "/checkpoint_000000066.h5";

struct Resume : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  const std::string whole = scratch.path() + "/whole";

  /// A signal stops a run, and resuming it ends in the results of a run that was not stopped.
  void stop_and_resume(int signal)
  {
    Process running(longer_run(folder, "1"));
    wait_for_rows(folder);
    running.send(signal);
    const Finished f = running.wait();
    EXPECT_EQ(f.status, 1);
    EXPECT_THAT(f.out, AllOf(HasSubstr("stopped at t = "),
                           HasSubstr("a checkpoint is written. Go on with:\n  terp resume " + folder + "\n")));
    EXPECT_EQ(nlohmann::json::parse(text_of(folder + "/summary.json")).at("finished"), false);

    EXPECT_THAT(succeeded(test::terp({"resume", folder, "-j", "2"})).out,
        AllOf(StartsWith("resuming " + folder + " at t = "), HasSubstr("solved in ")));
    EXPECT_EQ(nlohmann::json::parse(text_of(folder + "/summary.json")).at("finished"), true);
    ASSERT_EQ(test::terp(longer_run(whole, "1")).status, 0);
    expect_same_results(whole, folder, "/checkpoint_000001320.h5");
  }
};

TEST_F(Resume, AfterCtrlCEndsInTheResultsOfARunThatWasNotStopped) { stop_and_resume(SIGINT); }

TEST_F(Resume, AfterSigtermEndsInTheResultsOfARunThatWasNotStopped) { stop_and_resume(SIGTERM); }

TEST_F(Resume, AfterSighupEndsInTheResultsOfARunThatWasNotStopped) { stop_and_resume(SIGHUP); }

TEST_F(Resume, WherePointsLeftSinceTheLastRowOfTheLedgerEndsInTheSameResults)
{
  const std::string again = scratch.path() + "/again";
  succeeded(run_column(
      whole, {"-q", "--set", "mesh.size=[8.5, 3]", "--set", "boundary.right=open", "--set", "body.0.velocity=[8, 0]",
                 "--set", "output.ledger.every=0.15", "--set", "output.checkpoint={every=0.1, keep=0}"}));
  std::filesystem::copy(whole, again, std::filesystem::copy_options::recursive);
  succeeded(test::terp({"resume", again + "/checkpoint_000000033.h5", "-j", "1"}));
  expect_same_results(whole, again, last_checkpoint);
  EXPECT_EQ(text_of(whole + "/left_the_mesh.csv"), text_of(again + "/left_the_mesh.csv"));
}

TEST_F(Resume, WhereAFolderOrAPipeStandsForAFileOfTheRunIsRefused)
{
  succeeded(run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set", "output.mesh=true"}));
  for (const std::string name : {"mesh.vtkhdf", "history.csv", "ledger.csv", "left_the_mesh.csv", "footings.csv"}) {
    for (const bool is_pipe : {false, true}) {
      const std::string folder = scratch.path() + (is_pipe ? "/pipe_" : "/folder_") + name, path = folder + "/" + name;
      std::filesystem::copy(whole, folder, std::filesystem::copy_options::recursive);
      std::filesystem::remove(path);
      if (is_pipe)
        ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
      else
        std::filesystem::create_directory(path);
      const Finished f = test::terp({"resume", folder});
      EXPECT_EQ(f.status, 1) << path;
      EXPECT_THAT(f.err, AllOf(StartsWith("error: cannot "), HasSubstr(path),
                             HasSubstr(is_pipe ? "a pipe or device is in the place of the file"
                                               : "a folder is in the place of the file"),
                             HasSubstr("Put the file back")));
      EXPECT_EQ(text_of(folder + "/case.toml"), text_of(whole + "/case.toml"));
    }
  }
}

TEST_F(Resume, SaysFirstThatAnotherTerpIsWriting)
{
  Process running(longer_run(folder, "1"));
  wait_for_rows(folder);
  const std::string refused = "error: another terp is writing to the run folder " + folder + "\n";
  EXPECT_EQ(test::terp({"resume", folder}).err, refused);  // though there is no checkpoint yet
  std::filesystem::remove(folder + "/case.toml");
  EXPECT_EQ(test::terp({"resume", folder}).err, refused);
}

}  // namespace resume_test
