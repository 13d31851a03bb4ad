#include "cli/same_results.hpp"
#include "io/files/small_disk.hpp"
#include "support/leaks.hpp"
#include <csignal>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace run_test {

const std::string last_checkpoint = "/checkpoint_000000066.h5";

struct Run : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
};

TEST_F(Run, NotOnATerminalTellsPlainLinesWithoutControlCharacters)
{
  const Finished f = run_column(folder);
  EXPECT_TRUE(std::all_of(f.out.begin(), f.out.end(), [](unsigned char c) { return c == '\n' || c >= ' '; }));
  EXPECT_THAT(f.out, HasSubstr("100.0 %  t = 0.200 of 0.2 s  step 66 of 66  "));
  EXPECT_THAT(f.out, HasSubstr("M point-steps/s  ETA "));
}

TEST_F(Run, OnATerminalTellsItsProgressInOneLineThatIsWrittenAnew)
{
  if (std::system("command -v script > /dev/null") != 0) GTEST_SKIP() << "needs script(1)";
  const std::string command = "script -qec '" + program() + " run " + column_file +
                              " --set mesh.cell=0.5 --set time.end=0.2 -j 1 -o " + scratch.path() +
                              "/run' /dev/null < /dev/null > " + scratch.path() + "/seen";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(text_of(scratch.path() + "/seen"),
      AllOf(HasSubstr("\r\033[K100.0 %  t = 0.200 of 0.2 s"), HasSubstr("solved in ")));
}

TEST_F(Run, OnAFullDiskFailsWithThePathAndTheReason)
{
  const SmallDisk disk(600 * 1024);  // less than the first frame and a checkpoint
  if (!disk.is_there()) GTEST_SKIP() << "needs the right to mount a tmpfs";
  const std::string full = disk.path() + "/run";
  EXPECT_THAT(error_with(1, run_column(full, {"--set", "output.fields.every=0.01"})),
      AllOf(StartsWith("error: "), HasSubstr(full), HasSubstr("No space left on device"),
          HasSubstr("\n  No checkpoint was written yet. Make room on the disk, or mend what is told "
                    "above, then give the same command with --force.\n")));
}

TEST_F(Run, OnADiskThatFillsUpSaysHowToGoOnAndCanGoOn)
{
  const SmallDisk disk(26 << 20);
  if (!disk.is_there()) GTEST_SKIP() << "needs the right to mount a tmpfs";
  const std::string full = disk.path() + "/run", filler = disk.path() + "/mine";
  const std::vector<std::string> often{
      "-q", "--set", "output.fields.every=0.01", "--set", "output.checkpoint.every=0.03"};
  write_text(filler, std::string((24 << 20) + (1 << 19), 'x'));
  EXPECT_THAT(error_with(1, run_column(full, often)),
      MatchesRegex("error: cannot write " + full +
                   "/[a-z0-9_./]+: No space left on device\n"
                   "  Earlier results are intact, up to the checkpoint at t = 0[.][0-9]+ s. "
                   "Make room on the disk, or mend what is told above, then go on with:\n"
                   "  terp resume " +
                   full + "\n"));
  std::filesystem::remove(filler);
  succeeded(test::terp({"resume", full, "-q", "-j", "1"}));
  succeeded(run_column(folder, often));
  EXPECT_EQ(text_of(full + "/ledger.csv"), text_of(folder + "/ledger.csv"));
}

TEST_F(Run, OnTwoThreadsGivesTheResultsOfOne)
{
  const std::string one = scratch.path() + "/one", two = scratch.path() + "/two";
  succeeded(run_column(one, {"-q"}));
  std::vector<std::string> words = column_command("run", {"-o", two, "-q"});
  *(std::find(words.begin(), words.end(), "-j") + 1) = "2";
  succeeded(test::terp(words));
  expect_same_results(one, two, last_checkpoint);
}

TEST_F(Run, OfTheCaseInARunFolderRepeatsIt)
{
  const std::string first = scratch.path() + "/first", again = scratch.path() + "/again";
  succeeded(run_column(first, {"-q"}));
  succeeded(test::terp({"run", first + "/case.toml", "-o", again, "-q", "-j", "1"}));
  expect_same_results(first, again, last_checkpoint);
}

/// A run without checkpoints of its own gets this signal several times, as from GNU timeout, and keeps its work.
void stop_with_repeated(int signal)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  Process running(longer_run(folder, "1"));
  wait_for_rows(folder);
  for (int k = 0; k < 8; ++k) running.send(signal), ::usleep(4000);
  const Finished f = running.wait();
  EXPECT_EQ(f.status, 1) << signal;
  EXPECT_THAT(f.out, HasSubstr("a checkpoint is written")) << signal;
  EXPECT_THAT(names_in(folder), Contains(StartsWith("checkpoint_"))) << signal;
}

TEST_F(Run, KeepsItsWorkWhenASignalComesMoreThanOnce) { stop_with_repeated(SIGTERM); }

TEST_F(Run, KeepsItsWorkOnTheSignalsOfBatchSystems)
{
  for (const int signal : {SIGUSR1, SIGUSR2, SIGXCPU, SIGQUIT}) stop_with_repeated(signal);
}

TEST_F(Run, EqualRunsLeaveEqualFilesButForTheSummary)
{
  const std::string one = scratch.path() + "/one", two = scratch.path() + "/two";
  for (const auto& folder : {one, two}) ASSERT_EQ(run_column(folder, {"-q", "--set", "output.mesh=true"}).status, 0);
  for (const std::string& name : names_in(one)) {
    if (name == "summary.json" || name == "frames") continue;
    EXPECT_TRUE(text_of(one + "/" + name) == text_of(two + "/" + name)) << name;
  }
  EXPECT_TRUE(frames_of(one) == frames_of(two));
  EXPECT_THAT(frames_of(one), SizeIs(testing::Gt(3)));
}

}  // namespace run_test
