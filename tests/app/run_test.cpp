// terp run and terp resume, as a user meets them: files, messages, exit statuses.
#include "app/coarse_column.hpp"
#include "app/same_results.hpp"
#include "output/checkpoint.hpp"
#include "output/small_disk.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

/// For the leak sanitizer: HDF5 1.10 itself loses memory.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

namespace terp {
namespace {

using test::Finished;
using test::run_column;
using test::text_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
const std::string last_checkpoint = "/checkpoint_000000066.h5";

TEST(Run, LeavesAllItsFilesAndSaysWhereTheyAre)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  const Finished f = run_column(folder);
  EXPECT_EQ(f.status, 0);
  EXPECT_EQ(f.err, "");
  EXPECT_THAT(f.out,
      AllOf(HasSubstr("solved in "), HasSubstr(": 1600 points, 66 steps of 0.00303 s, "), HasSubstr(" on 1 thread\n"),
          HasSubstr("points lost: 0; put back at walls: 0; left through open sides: 0\n"),
          HasSubstr("results in " + folder + "\n")));
  EXPECT_THAT(test::names_in(folder), testing::IsSupersetOf({"case.toml", "checkpoint_000000066.h5", "history.csv",
                                          "ledger.csv", "mesh.vtkhdf", "results.vtkhdf.series", "summary.json"}));
  EXPECT_THAT(test::names_in(folder + "/frames"), testing::Contains("points_00000.vtkhdf"));
  const auto summary = nlohmann::json::parse(text_of(folder + "/summary.json"));
  EXPECT_EQ(summary.at("finished"), true);
  EXPECT_EQ(summary.at("steps"), 66);
  EXPECT_EQ(summary.at("points"), 1600);
  EXPECT_EQ(summary.at("scheme"), "mpm_gp");
  EXPECT_THAT(text_of(folder + "/history.csv"), HasSubstr("\n0,A,"));
}

TEST(Run, GoesToRunsAndTheNameOfTheCaseByDefault)
{
  const test::ScratchFolder scratch;
  EXPECT_EQ(test::terp(test::column_command("run", {"-q"}), scratch.path()).status, 0);
  EXPECT_TRUE(std::filesystem::exists(scratch.path() + "/runs/model_2/summary.json"));
}

TEST(Run, NotOnATerminalTellsPlainLinesWithoutControlCharacters)
{
  const test::ScratchFolder scratch;
  const Finished f = run_column(scratch.path() + "/run");
  EXPECT_TRUE(std::all_of(f.out.begin(), f.out.end(), [](unsigned char c) { return c == '\n' || c >= ' '; }));
  EXPECT_THAT(f.out, HasSubstr("100.0 %  t = 0.200 of 0.2 s  step 66 of 66  "));
  EXPECT_THAT(f.out, HasSubstr("M point-steps/s  ETA "));
}

TEST(Run, OnATerminalTellsItsProgressInOneLineThatIsWrittenAnew)
{
  const test::ScratchFolder scratch;
  if (std::system("command -v script > /dev/null") != 0) GTEST_SKIP() << "needs script(1)";
  const std::string command = "script -qec '" + test::program() + " run " + test::column_file +
                              " --set mesh.cell=0.5 --set time.end=0.2 -j 1 -o " + scratch.path() +
                              "/run' /dev/null < /dev/null > " + scratch.path() + "/seen";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(text_of(scratch.path() + "/seen"),
      AllOf(HasSubstr("\r\033[K100.0 %  t = 0.200 of 0.2 s"), HasSubstr("solved in ")));
}

TEST(Run, QuietSaysNothing)
{
  const test::ScratchFolder scratch;
  const Finished f = run_column(scratch.path() + "/run", {"-q"});
  EXPECT_EQ(f.status, 0);
  EXPECT_EQ(f.out + f.err, "");
}

TEST(Run, VerboseTellsTheTimeOfEachPass)
{
  const test::ScratchFolder scratch;
  const Finished f = run_column(scratch.path() + "/run", {"-v"});
  for (const char* pass : {"points to cells", "nodes", "cells to points", "velocities", "stress", "move"})
    EXPECT_THAT(f.out, HasSubstr(pass));
}

TEST(Run, DoesNotTouchAnEarlierRunWithoutForce)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  ASSERT_EQ(run_column(folder).status, 0);
  const std::string summary = text_of(folder + "/summary.json"), checkpoint = text_of(folder + last_checkpoint);
  const Finished refused = run_column(folder, {"--set", "scheme=mpm_mixed"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, AllOf(StartsWith("error: "), HasSubstr(folder), HasSubstr("--force")));
  EXPECT_EQ(text_of(folder + "/summary.json"), summary);
  EXPECT_EQ(text_of(folder + last_checkpoint), checkpoint);
  EXPECT_EQ(run_column(folder, {"--set", "scheme=mpm_mixed", "--force"}).status, 0);
  EXPECT_THAT(text_of(folder + "/summary.json"), HasSubstr("mpm_mixed"));
}

TEST(Run, OfABadCaseNamesFileAndLineAndLeavesNothing)
{
  const test::ScratchFolder scratch;
  std::string text = text_of(test::column_file);
  text.replace(text.find("su_residual   = 2.0e3"), 11, "su_resdiual");
  test::write_text(scratch.path() + "/bad.toml", text);
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("su_resdiual")), '\n');
  const Finished f = test::terp({"run", "bad.toml", "-o", "run"}, scratch.path());
  EXPECT_EQ(f.status, 2);
  EXPECT_EQ(f.out, "");
  EXPECT_THAT(f.err, AllOf(StartsWith("error: bad.toml:" + std::to_string(line) + ":1: unknown key `su_resdiual`"),
                         HasSubstr("Did you mean `su_residual`?"), HasSubstr("nothing was run")));
  EXPECT_THAT(test::names_in(scratch.path()), ElementsAre("bad.toml"));
}

TEST(Run, OfAFileThatIsNotThereIsBadInput)
{
  const Finished f = test::terp({"run", "no/such/case.toml"});
  EXPECT_EQ(f.status, 2);
  EXPECT_THAT(f.err, HasSubstr("no/such/case.toml"));
}

TEST(Run, IntoAPlaceThatIsNoFolderFails)
{
  const test::ScratchFolder scratch;
  test::write_text(scratch.path() + "/file", "mine");
  const Finished f = run_column(scratch.path() + "/file/run");
  EXPECT_EQ(f.status, 1);
  EXPECT_THAT(f.err, AllOf(StartsWith("error: "), HasSubstr(scratch.path() + "/file")));
  EXPECT_EQ(text_of(scratch.path() + "/file"), "mine");
}

TEST(Run, OnAFullDiskFailsWithThePathAndTheReason)
{
  const test::SmallDisk disk(600 * 1024);  // less than the first frame and a checkpoint
  if (!disk.is_there()) GTEST_SKIP() << "needs the right to mount a tmpfs";
  const std::string folder = disk.path() + "/run";
  const Finished f = run_column(folder, {"--set", "output.fields.every=0.01"});
  EXPECT_EQ(f.status, 1);
  EXPECT_THAT(f.err, AllOf(StartsWith("error: "), HasSubstr(folder), HasSubstr("No space left on device"),
                         HasSubstr("\n  No checkpoint was written yet. Make room on the disk, or mend what is told "
                                   "above, then give the same command with --force.\n")));
}

TEST(Run, OnADiskThatFillsUpSaysHowToGoOnAndCanGoOn)
{
  const test::SmallDisk disk(26 << 20);
  if (!disk.is_there()) GTEST_SKIP() << "needs the right to mount a tmpfs";
  const std::string folder = disk.path() + "/run", filler = disk.path() + "/mine";
  const std::vector<std::string> often{
      "-q", "--set", "output.fields.every=0.01", "--set", "output.checkpoint.every=0.03"};
  test::write_text(filler, std::string((24 << 20) + (1 << 19), 'x'));
  const Finished f = run_column(folder, often);
  EXPECT_EQ(f.status, 1);
  EXPECT_THAT(f.err, testing::MatchesRegex("error: cannot write " + folder +
                                           "/[a-z0-9_./]+: No space left on device\n"
                                           "  Earlier results are intact, up to the checkpoint at t = 0[.][0-9]+ s. "
                                           "Make room on the disk, or mend what is told above, then go on with:\n"
                                           "  terp resume " +
                                           folder + "\n"));
  std::filesystem::remove(filler);
  const Finished resumed = test::terp({"resume", folder, "-q", "-j", "1"});
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  const test::ScratchFolder scratch;
  ASSERT_EQ(run_column(scratch.path() + "/run", often).status, 0);
  EXPECT_EQ(text_of(folder + "/ledger.csv"), text_of(scratch.path() + "/run/ledger.csv"));
}

TEST(Run, ThatStopsItselfHasAStatusOfItsOwnAndKeepsItsState)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  const Finished f = run_column(
      folder, {"--set", "body[0].velocity=[60.0, 0.0]", "--set", "boundary.right=\"free\"", "--set", "time.end=0.3"});
  EXPECT_EQ(f.status, 3);
  EXPECT_THAT(f.err,
      AllOf(HasSubstr("points had to be put back at the walls"), HasSubstr("  saved    " + folder + "/failed_")));
  EXPECT_THAT(test::names_in(folder), testing::Contains(StartsWith("failed_")));
  EXPECT_EQ(nlohmann::json::parse(text_of(folder + "/summary.json")).at("finished"), false);
}

TEST(Run, SaysWhenSoilCameToASideOfTheMesh)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";  // the column from 0 to 8 m, a wall 1 m before it
  const Finished f =
      run_column(folder, {"-q", "--set", "body[0].velocity=[8.0, 0.0]", "--set", "mesh.size=[9.5, 3.0]"});
  EXPECT_EQ(f.status, 0) << f.err;
  const auto reached = nlohmann::json::parse(text_of(folder + "/summary.json")).at("reached_sides");
  ASSERT_EQ(reached.size(), 1u) << reached;
  EXPECT_EQ(reached[0].at("side"), "right");
  EXPECT_NEAR(reached[0].at("time").get<double>(), 1.05 / 8.0, 0.02);
  EXPECT_THAT(f.err, testing::ContainsRegex("warning: [^ ]*: soil came to the side `right` of the mesh by t = 0.1"));
}

TEST(Run, OnTwoThreadsGivesTheResultsOfOne)
{
  const test::ScratchFolder scratch;
  const std::string one = scratch.path() + "/one", two = scratch.path() + "/two";
  ASSERT_EQ(run_column(one, {"-q"}).status, 0);
  std::vector<std::string> words = test::column_command("run", {"-o", two, "-q"});
  *(std::find(words.begin(), words.end(), "-j") + 1) = "2";
  ASSERT_EQ(test::terp(words).status, 0);
  test::expect_same_results(one, two, last_checkpoint);
}

TEST(Run, OfTheCaseInARunFolderRepeatsIt)
{
  const test::ScratchFolder scratch;
  const std::string first = scratch.path() + "/first", again = scratch.path() + "/again";
  ASSERT_EQ(run_column(first, {"-q"}).status, 0);
  ASSERT_EQ(test::terp({"run", first + "/case.toml", "-o", again, "-q", "-j", "1"}).status, 0);
  test::expect_same_results(first, again, last_checkpoint);
}

/// A signal stops a run, and resuming it ends in the results of a run that was not stopped.
void stop_and_resume(int signal)
{
  const test::ScratchFolder scratch;
  const std::string whole = scratch.path() + "/whole", stopped = scratch.path() + "/stopped";
  test::Process running(test::longer_run(stopped, "1"));
  test::wait_for_rows(stopped);
  running.send(signal);
  const Finished f = running.wait();
  EXPECT_EQ(f.status, 1);
  EXPECT_THAT(f.out, AllOf(HasSubstr("stopped at t = "),
                         HasSubstr("a checkpoint is written. Go on with:\n  terp resume " + stopped + "\n")));
  EXPECT_EQ(nlohmann::json::parse(text_of(stopped + "/summary.json")).at("finished"), false);

  const Finished resumed = test::terp({"resume", stopped, "-j", "2"});
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_THAT(resumed.out, AllOf(StartsWith("resuming " + stopped + " at t = "), HasSubstr("solved in ")));
  EXPECT_EQ(nlohmann::json::parse(text_of(stopped + "/summary.json")).at("finished"), true);
  ASSERT_EQ(test::terp(test::longer_run(whole, "1")).status, 0);
  test::expect_same_results(whole, stopped, "/checkpoint_000001320.h5");
}

TEST(Resume, AfterCtrlCEndsInTheResultsOfARunThatWasNotStopped) { stop_and_resume(SIGINT); }

TEST(Resume, AfterSigtermEndsInTheResultsOfARunThatWasNotStopped) { stop_and_resume(SIGTERM); }

TEST(Resume, AfterSighupEndsInTheResultsOfARunThatWasNotStopped) { stop_and_resume(SIGHUP); }

/// A run without checkpoints of its own gets this signal several times, as from GNU timeout, and keeps its work.
void stop_with_repeated(int signal)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  test::Process running(test::longer_run(folder, "1"));
  test::wait_for_rows(folder);
  for (int k = 0; k < 8; ++k) running.send(signal), ::usleep(4000);
  const Finished f = running.wait();
  EXPECT_EQ(f.status, 1) << signal;
  EXPECT_THAT(f.out, HasSubstr("a checkpoint is written")) << signal;
  EXPECT_THAT(test::names_in(folder), testing::Contains(StartsWith("checkpoint_"))) << signal;
}

TEST(Run, KeepsItsWorkWhenASignalComesMoreThanOnce) { stop_with_repeated(SIGTERM); }

TEST(Run, KeepsItsWorkOnTheSignalsOfBatchSystems)
{
  for (const int signal : {SIGUSR1, SIGUSR2, SIGXCPU, SIGQUIT}) stop_with_repeated(signal);
}

TEST(Resume, FromACheckpointThatIsNamedEndsInTheSameResults)
{
  const test::ScratchFolder scratch;
  const std::string whole = scratch.path() + "/whole", again = scratch.path() + "/again";
  ASSERT_EQ(
      run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set", "output.mesh=true"}).status,
      0);
  std::filesystem::copy(whole, again, std::filesystem::copy_options::recursive);
  const Finished f = test::terp({"resume", again + "/checkpoint_000000033.h5", "-j", "1"});
  EXPECT_EQ(f.status, 0) << f.err;
  EXPECT_THAT(f.out, HasSubstr("step 33 of 66\n"));
  test::expect_same_results(whole, again, last_checkpoint);
  EXPECT_EQ(text_of(whole + "/mesh.vtkhdf.series"), text_of(again + "/mesh.vtkhdf.series"));
}

TEST(Resume, SkipsADamagedCheckpointAndSaysSo)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  ASSERT_EQ(run_column(folder, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}"}).status, 0);
  std::filesystem::resize_file(folder + last_checkpoint, 1000);
  const Finished f = test::terp({"resume", folder, "-j", "1"});
  EXPECT_EQ(f.status, 0);
  EXPECT_THAT(f.err, HasSubstr("warning: skipped " + folder + last_checkpoint));
  EXPECT_NO_THROW(read_checkpoint(folder + last_checkpoint));
}

TEST(Resume, WithoutARunOrACheckpointFails)
{
  const test::ScratchFolder scratch;
  const Finished nowhere = test::terp({"resume", scratch.path() + "/none"});
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_EQ(nowhere.err, "error: " + scratch.path() + "/none: no such run folder\n");
  const std::string folder = scratch.path() + "/run";
  ASSERT_EQ(run_column(folder, {"-q"}).status, 0);
  std::filesystem::remove(folder + last_checkpoint);
  const Finished f = test::terp({"resume", folder});
  EXPECT_EQ(f.status, 1);
  EXPECT_EQ(f.err, "error: " + folder + ": no checkpoint to resume from. Start the case anew with `terp run`.\n");
}

TEST(Resume, OfACaseFileSaysWhatItTakesAndWhatRunIsFor)
{
  const test::ScratchFolder scratch;
  test::write_text(scratch.path() + "/base.toml", "");
  const Finished f = test::terp({"resume", "base.toml"}, scratch.path());
  EXPECT_EQ(f.status, 2);
  EXPECT_EQ(f.err,
      "error: base.toml: `terp resume` takes a run folder, as in terp resume runs/base\n"
      "  It goes on from the newest checkpoint there. To solve a case file from its start: terp run base.toml\n");
  EXPECT_THAT(test::terp({"resume", "runs/base/case.toml"}).err, HasSubstr("as in terp resume runs/base\n"));
  EXPECT_EQ(test::terp({"resume", scratch.path()}).err,
      "error: " + scratch.path() + ": this is no run folder, it holds no case.toml\n");
  std::filesystem::create_directory(scratch.path() + "/folder.toml");
  EXPECT_EQ(test::terp({"resume", "folder.toml"}, scratch.path()).err,
      "error: folder.toml: this is no run folder, it holds no case.toml\n");
}

TEST(Resume, WhereAFileOfTheRunIsMissingOrShortIsRefused)
{
  const test::ScratchFolder scratch;
  const std::string whole = scratch.path() + "/whole";
  ASSERT_EQ(run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set",
                                  "output.fields.every=0.05", "--set", "output.mesh=true"})
                .status,
      0);
  std::filesystem::remove(whole + last_checkpoint);
  for (const std::string name : {"history.csv", "ledger.csv"}) {
    const std::string folder = scratch.path() + "/no_" + name;
    std::filesystem::copy(whole, folder, std::filesystem::copy_options::recursive);
    std::filesystem::remove(folder + "/" + name);
    const auto before = test::names_in(folder);
    const Finished f = test::terp({"resume", folder});
    EXPECT_EQ(f.status, 1) << name;
    EXPECT_THAT(f.err, StartsWith("error: cannot resume from step 33, t = 0.1 s, without all of " + folder + "/" +
                                  name + ": it is missing\n"));
    EXPECT_EQ(test::names_in(folder), before);
  }
  const std::string ledger = text_of(whole + "/ledger.csv");
  test::write_text(whole + "/ledger.csv", ledger.substr(0, ledger.find("\n0.06") + 1));
  EXPECT_THAT(test::terp({"resume", whole}).err, HasSubstr("/ledger.csv: it holds 6 rows up to there, 11 are due\n"));
  test::write_text(whole + "/ledger.csv", ledger);
  EXPECT_EQ(test::terp({"resume", whole, "-q", "-j", "1"}).status, 0);
}

TEST(Resume, WhereAFolderOrAPipeStandsForAFileOfTheRunIsRefused)
{
  const test::ScratchFolder scratch;
  const std::string whole = scratch.path() + "/whole";
  ASSERT_EQ(
      run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set", "output.mesh=true"}).status,
      0);
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

TEST(Resume, WhereFramesWereCutNamesThemAndGoesOn)
{
  const test::ScratchFolder scratch;
  const std::string whole = scratch.path() + "/whole", folder = scratch.path() + "/cut",
                    cut = folder + "/frames/points_00001.vtkhdf";
  ASSERT_EQ(run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set",
                                  "output.fields.every=0.05", "--set", "output.mesh=true"})
                .status,
      0);
  std::filesystem::remove(whole + last_checkpoint);
  std::filesystem::copy(whole, folder, std::filesystem::copy_options::recursive);
  for (const std::string& path : {cut, folder + "/mesh.vtkhdf"})
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const Finished f = test::terp({"resume", folder, "-q", "-j", "1"});
  EXPECT_EQ(f.status, 0);
  EXPECT_THAT(f.err, AllOf(HasSubstr("warning: " + cut + " is damaged; the run goes on without it: cannot read " + cut),
                         HasSubstr("warning: " + folder + "/mesh.vtkhdf is damaged; it is written again")));
  auto expected = test::frames_of(whole);
  const auto seen = test::frames_of(folder);
  expected["points_00001.vtkhdf"] = seen.at("points_00001.vtkhdf");
  EXPECT_TRUE(seen == expected);
  EXPECT_TRUE(text_of(folder + "/mesh.vtkhdf") == text_of(whole + "/mesh.vtkhdf"));
  EXPECT_THAT(text_of(folder + "/results.vtkhdf.series"), testing::Not(HasSubstr("points_00001")));
  EXPECT_THAT(test::terp({"export", folder, "-o", scratch.path() + "/csv"}).err,
      HasSubstr("warning: " + cut + " is left out: cannot read " + cut));
}

TEST(Run, EqualRunsLeaveEqualFilesButForTheSummary)
{
  const test::ScratchFolder scratch;
  const std::string one = scratch.path() + "/one", two = scratch.path() + "/two";
  for (const auto& folder : {one, two}) ASSERT_EQ(run_column(folder, {"-q", "--set", "output.mesh=true"}).status, 0);
  for (const std::string& name : test::names_in(one)) {
    if (name == "summary.json" || name == "frames") continue;
    EXPECT_TRUE(text_of(one + "/" + name) == text_of(two + "/" + name)) << name;
  }
  EXPECT_TRUE(test::frames_of(one) == test::frames_of(two));
  EXPECT_THAT(test::frames_of(one), testing::SizeIs(testing::Gt(3)));
}

TEST(Resume, WithAFileOfAnotherRunOfTheSameSizeIsRefused)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run", other = scratch.path() + "/other";
  ASSERT_EQ(run_column(folder, {"-q"}).status, 0);
  ASSERT_EQ(run_column(other, {"-q", "--set", "material.clay.eta=40"}).status, 0);
  for (const std::string name : {"/frames/points_00000.vtkhdf", "/history.csv", "/ledger.csv"}) {
    const std::string ours = text_of(folder + name);
    test::write_text(folder + name, text_of(other + name));
    const Finished f = test::terp({"resume", folder});
    EXPECT_EQ(f.status, 1) << name;
    EXPECT_THAT(f.err, AllOf(StartsWith("error: cannot resume from step 66, t = 0.2 s: " + folder + name + " is "),
                           HasSubstr("Nothing was changed")));
    test::write_text(folder + name, ours);
  }
  EXPECT_EQ(test::terp({"resume", folder, "-q"}).status, 0);
}

/// Writes the case of a run folder anew with `from` replaced.
void edit_case(const std::string& folder, const std::string& from, const std::string& to)
{
  std::string text = text_of(folder + "/case.toml");
  test::write_text(folder + "/case.toml", text.replace(text.find(from), from.size(), to));
}

TEST(Resume, OfACaseThatWasChangedIsRefusedWithWhatChanged)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  ASSERT_EQ(run_column(folder, {"-q"}).status, 0);
  edit_case(folder, "[5, 5]", "[4, 4]");
  edit_case(folder, "eta = 50.0", "eta = 40.0  # softer");
  const auto before = test::names_in(folder);
  const Finished f = test::terp({"resume", folder});
  EXPECT_EQ(f.status, 1);
  EXPECT_EQ(f.err, "error: cannot resume from step 66: " + folder +
                       "/case.toml was changed since the run began\n"
                       "  body[0].points_per_cell ([5, 5], now [4, 4])\n"
                       "  material.clay.eta (50, now 40)\n"
                       "  Put back what it began with, or solve the changed case from its start: terp run " +
                       folder +
                       "/case.toml -o NEW_FOLDER\n"
                       "  These may change: title, time.end, output.fields.every, output.checkpoint\n");
  EXPECT_EQ(test::names_in(folder), before);
  edit_case(folder, "[4, 4]", "5");
  edit_case(folder, "eta = 40.0", "eta = 5.0e1");
  EXPECT_EQ(test::terp({"resume", folder, "-q"}).status, 0);
}

TEST(Resume, WithALaterEndGoesOnInTheSameTimeStepWithoutGapOrDoubleRows)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run", whole = scratch.path() + "/whole";
  ASSERT_EQ(run_column(folder, {"-q", "--set", "output.fields.every=0.05"}).status, 0);
  ASSERT_EQ(run_column(whole, {"-q", "--set", "output.fields.every=0.05", "--set", "time.end=0.4"}).status, 0);
  edit_case(folder, "end = 0.2", "end = 0.4");
  const Finished f = test::terp({"resume", folder, "-j", "1"});
  EXPECT_EQ(f.status, 0) << f.err;
  EXPECT_THAT(
      f.out, AllOf(HasSubstr("step 66 of 132\n"), HasSubstr("  from here on with another time.end (0.2, now 0.4)\n")));
  test::expect_same_results(
      whole, folder, "/checkpoint_000000132.h5");  // 0.4 s are just twice as many of the same steps
  edit_case(folder, "end = 0.4", "end = 0.401");
  EXPECT_THAT(test::terp({"resume", folder, "-j", "1"}).out, HasSubstr("step 132 of 133\n"));
  edit_case(folder, "end = 0.401", "end = 0.3");
  EXPECT_EQ(test::terp({"resume", folder}).err,
      "error: cannot resume from step 133, t = 0.403 s: time.end = 0.3 s lies before it\n"
      "  Set a later time.end in case.toml of the folder, or name an earlier checkpoint.\n");
}

TEST(Resume, SaysFirstThatAnotherTerpIsWriting)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  test::Process running(test::longer_run(folder, "1"));
  test::wait_for_rows(folder);
  const std::string refused = "error: another terp is writing to the run folder " + folder + "\n";
  EXPECT_EQ(test::terp({"resume", folder}).err, refused);  // though there is no checkpoint yet
  std::filesystem::remove(folder + "/case.toml");
  EXPECT_EQ(test::terp({"resume", folder}).err, refused);
}

}  // namespace
}  // namespace terp
