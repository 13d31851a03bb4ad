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

TEST_F(Run, LeavesAllItsFilesAndSaysWhereTheyAre)
{
  const Finished f = succeeded(run_column(folder));
  EXPECT_EQ(f.err, "");
  EXPECT_THAT(f.out,
      AllOf(HasSubstr("solved in "), HasSubstr(": 1600 points, 66 steps of 0.00303 s, "), HasSubstr(" on 1 thread\n"),
          HasSubstr("points lost: 0; put back at walls: 0; left through open sides: 0\n"),
          HasSubstr("results in " + folder + "\n")));
  EXPECT_THAT(names_in(folder), testing::IsSupersetOf({"case.toml", "checkpoint_000000066.h5", "history.csv",
                                    "ledger.csv", "mesh.vtkhdf", "results.vtkhdf.series", "summary.json"}));
  EXPECT_THAT(names_in(folder + "/frames"), Contains("points_00000.vtkhdf"));
  const auto summary = nlohmann::json::parse(text_of(folder + "/summary.json"));
  EXPECT_EQ(summary.at("finished"), true);
  EXPECT_EQ(summary.at("steps"), 66);
  EXPECT_EQ(summary.at("points"), 1600);
  EXPECT_EQ(summary.at("scheme"), "mpm_gp");
  EXPECT_THAT(text_of(folder + "/history.csv"), HasSubstr("\n0,A,"));
}

TEST_F(Run, SaysInItsSummaryWhereSoilSoftenedWithoutALength)
{
  const char* line =
      "\n  softening        no length, no reference width: the result depends on the cells (docs/convergence.md)\n";
  EXPECT_THAT(run_column(scratch.path() + "/point").out, HasSubstr(line));
  for (const char* change : {"material.clay.softening.length=0.6", "material.clay.softening.reference_width=0.5",
           "material.clay.su_residual=8e3", "time.end=0.02"}) {
    EXPECT_THAT(
        succeeded(run_column(scratch.path() + "/" + change, {"--set", change})).out, Not(HasSubstr("softening  ")))
        << change;
  }
}

TEST_F(Run, AtAStrengthIsRecordedAndResumedAndCompared)
{
  const std::string weak = scratch.path() + "/weak", full = scratch.path() + "/full";
  EXPECT_THAT(succeeded(run_column(weak, {"--at-strength", "1.25", "--set", "output.checkpoint.every=0.1"})).out,
      HasSubstr("\n  strengths        divided by 1.25\n"));
  EXPECT_EQ(nlohmann::json::parse(text_of(weak + "/summary.json")).at("at_strength"), 1.25);
  EXPECT_THAT(text_of(weak + "/case.toml"), HasSubstr("at_strength = 1.25"));
  const std::string end = text_of(weak + "/history.csv");
  EXPECT_THAT(succeeded(test::terp({"resume", weak + "/checkpoint_000000033.h5", "-j", "1"})).out,
      HasSubstr("\n  strengths        divided by 1.25\n"));
  EXPECT_EQ(text_of(weak + "/history.csv"), end);
  EXPECT_THAT(run_column(full).out, Not(HasSubstr("strengths")));
  EXPECT_THAT(test::terp({"compare", full, weak}).out, HasSubstr("at_strength"));
}

TEST_F(Run, RefusesAStrengthThatCannotBe)
{
  EXPECT_THAT(error_with(2, run_column(folder, {"--at-strength", "0"})), HasSubstr("`at_strength` is out of range"));
  EXPECT_THAT(error_with(2, run_column(folder,
                                {"--at-strength", "1.2", "--set",
                                    "material.clay={model=\"newtonian_fluid\", density=1000.0, bulk_modulus=1e6}"})),
      AllOf(HasSubstr("the strength of `clay` cannot be divided"),
          HasSubstr("Got at_strength = 1.2. Soil of the law newtonian_fluid has none that a factor could divide")));
  EXPECT_THAT(
      error_with(
          2, run_column(folder,
                 {"--at-strength", "1.2", "--set",
                     "material.clay={model=\"linear_elastic\", density=1000.0, shear_modulus=1e6, poisson_ratio=0.3}",
                     "--set", "boundary.bottom=\"roller\""})),
      HasSubstr("no material of this case has a strength to divide"));
}

TEST_F(Run, GoesToRunsAndTheNameOfTheCaseByDefault)
{
  succeeded(test::terp(column_command("run", {"-q"}), scratch.path()));
  EXPECT_TRUE(std::filesystem::exists(scratch.path() + "/runs/model_2/summary.json"));
}

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

TEST_F(Run, QuietSaysNothing)
{
  const Finished f = succeeded(run_column(folder, {"-q"}));
  EXPECT_EQ(f.out + f.err, "");
}

TEST_F(Run, VerboseTellsTheTimeOfEachPass)
{
  const Finished f = run_column(folder, {"-v"});
  for (const char* pass : {"points to cells", "nodes", "cells to points", "velocities", "stress", "move"})
    EXPECT_THAT(f.out, HasSubstr(pass));
}

TEST_F(Run, DoesNotTouchAnEarlierRunWithoutForce)
{
  succeeded(run_column(folder));
  const std::string summary = text_of(folder + "/summary.json"), checkpoint = text_of(folder + last_checkpoint);
  EXPECT_THAT(error_with(1, run_column(folder, {"--set", "scheme=mpm_mixed"})),
      AllOf(StartsWith("error: "), HasSubstr(folder), HasSubstr("--force")));
  EXPECT_EQ(text_of(folder + "/summary.json"), summary);
  EXPECT_EQ(text_of(folder + last_checkpoint), checkpoint);
  succeeded(run_column(folder, {"--set", "scheme=mpm_mixed", "--force"}));
  EXPECT_THAT(text_of(folder + "/summary.json"), HasSubstr("mpm_mixed"));
}

TEST_F(Run, OfABadCaseNamesFileAndLineAndLeavesNothing)
{
  std::string text = text_of(column_file);
  text.replace(text.find("su_residual   = 2.0e3"), 11, "su_resdiual");
  write_text(scratch.path() + "/bad.toml", text);
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("su_resdiual")), '\n');
  const Finished f = test::terp({"run", "bad.toml", "-o", "run"}, scratch.path());
  EXPECT_EQ(f.status, 2);
  EXPECT_EQ(f.out, "");
  EXPECT_THAT(f.err, AllOf(StartsWith("error: bad.toml:" + std::to_string(line) + ":1: unknown key `su_resdiual`"),
                         HasSubstr("Did you mean `su_residual`?"), HasSubstr("nothing was run")));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("bad.toml"));
}

TEST_F(Run, OfAFileThatIsNotThereIsBadInput)
{
  EXPECT_THAT(error_with(2, test::terp({"run", "no/such/case.toml"})), HasSubstr("no/such/case.toml"));
}

TEST_F(Run, IntoAPlaceThatIsNoFolderFails)
{
  write_text(scratch.path() + "/file", "mine");
  EXPECT_THAT(error_with(1, run_column(scratch.path() + "/file/run")),
      AllOf(StartsWith("error: "), HasSubstr(scratch.path() + "/file")));
  EXPECT_EQ(text_of(scratch.path() + "/file"), "mine");
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

TEST_F(Run, ThatStopsItselfHasAStatusOfItsOwnAndKeepsItsState)
{
  EXPECT_THAT(error_with(3, run_column(folder, {"--set", "body[0].velocity=[60.0, 0.0]", "--set",
                                                   "boundary.right=\"free\"", "--set", "time.end=0.3"})),
      AllOf(HasSubstr("points had to be put back at the walls"), HasSubstr("  saved    " + folder + "/failed_")));
  EXPECT_THAT(names_in(folder), Contains(StartsWith("failed_")));
  EXPECT_EQ(nlohmann::json::parse(text_of(folder + "/summary.json")).at("finished"), false);
}

TEST_F(Run, SaysWhenSoilCameToASideOfTheMesh)
{
  // The column from 0 to 8 m, a wall 1 m before it
  const Finished f =
      succeeded(run_column(folder, {"-q", "--set", "body[0].velocity=[8.0, 0.0]", "--set", "mesh.size=[9.5, 3.0]"}));
  const auto reached = nlohmann::json::parse(text_of(folder + "/summary.json")).at("reached_sides");
  ASSERT_EQ(reached.size(), 1u) << reached;
  EXPECT_EQ(reached[0].at("side"), "right");
  EXPECT_NEAR(reached[0].at("time").get<double>(), 1.05 / 8.0, 0.02);
  EXPECT_THAT(f.err, ContainsRegex("warning: [^ ]*: soil came to the side `right` of the mesh by t = 0.1"));
}

TEST_F(Run, WarnsWhereLocalDampingTookFarMoreThanItsFactorPromises)
{
  const auto err = [&](const char* name, const std::vector<std::string>& more) {
    return run_column(scratch.path() + "/" + name, more).err;
  };
  EXPECT_THAT(err("noise", {"-q", "--set", "time.end=3"}),
      ContainsRegex("warning: [^ ]*: local damping took [0-9.]* times the energy that"));
  EXPECT_THAT(err("smooth", {"-q", "--set", "time.end=3", "--set", "method.shares=overlap", "--set",
                                "forces.damping.averaging_time=0.05"}),
      Not(HasSubstr("local damping")));
  // Slow loading has hardly any kinetic energy; the waves that damping takes are 0.4 % of the work.
  const Finished slow = test::terp({"run", source_path("cases/verification/strip_footing/case.toml"), "-q", "-o",
      scratch.path() + "/slow", "--set", "time.end=0.3"});
  EXPECT_THAT(slow.err, Not(HasSubstr("local damping")));
  EXPECT_GT(nlohmann::json::parse(text_of(scratch.path() + "/slow/summary.json")).at("damping_over_promised"), 7.0);
}

TEST_F(Run, WarnsWhereSoilCameToCellsTooWideForItsSofteningLength)
{
  const std::string path = scratch.path() + "/case.toml";
  write_text(path,  // a block flies from cells of 0.1 m to cells of 0.3 m
      "time.end = 0.3\nmesh = { size = [4.0, 1.0], cells = [20, 10], grading = [3.0, 1.0] }\n"
      "body = [{ material = \"clay\", box = [[0.1, 0.2], [0.4, 0.8]], velocity = [9.0, 0.0] }]\n"
      "[material.clay]\nmodel = \"tresca_softening\"\ndensity = 2000.0\nshear_modulus = 1e6\npoisson_ratio = 0.3\n"
      "su_peak = 8e3\nsu_residual = 2e3\neta = 20.0\nsoftening.length = 0.3\n");
  const auto run_with = [&](const std::string& length) {
    return test::terp(
        {"run", path, "-q", "-j", "1", "--force", "-o", folder, "--set", "material.clay.softening.length=" + length});
  };
  EXPECT_THAT(run_with("0.35").err,
      ContainsRegex("warning: [^ ]*/run: soil came to cells of which its softening length holds 1\\.[1-4]; see "
                    "docs/softening_length.md\n"));
  EXPECT_THAT(run_with("0.7").err, Not(HasSubstr("came to cells")));
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
