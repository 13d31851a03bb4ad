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

TEST_F(Resume, FromACheckpointThatIsNamedEndsInTheSameResults)
{
  const std::string again = scratch.path() + "/again";
  succeeded(run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set", "output.mesh=true"}));
  std::filesystem::copy(whole, again, std::filesystem::copy_options::recursive);
  EXPECT_THAT(succeeded(test::terp({"resume", again + "/checkpoint_000000033.h5", "-j", "1"})).out,
      HasSubstr("step 33 of 66\n"));
  expect_same_results(whole, again, last_checkpoint);
  EXPECT_EQ(text_of(whole + "/mesh.vtkhdf.series"), text_of(again + "/mesh.vtkhdf.series"));
}

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

TEST_F(Resume, SkipsADamagedCheckpointAndSaysSo)
{
  succeeded(run_column(folder, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}"}));
  std::filesystem::resize_file(folder + last_checkpoint, 1000);
  EXPECT_THAT(succeeded(test::terp({"resume", folder, "-j", "1"})).err,
      HasSubstr("warning: skipped " + folder + last_checkpoint));
  EXPECT_NO_THROW(read_checkpoint(folder + last_checkpoint));
}

TEST_F(Resume, WhereAFileOfTheRunIsMissingOrShortIsRefused)
{
  succeeded(run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set",
                                  "output.fields.every=0.05", "--set", "output.mesh=true"}));
  std::filesystem::remove(whole + last_checkpoint);
  for (const std::string name : {"history.csv", "ledger.csv"}) {
    const std::string folder = scratch.path() + "/no_" + name;
    std::filesystem::copy(whole, folder, std::filesystem::copy_options::recursive);
    std::filesystem::remove(folder + "/" + name);
    const auto before = names_in(folder);
    EXPECT_EQ(error_with(1, test::terp({"resume", folder})),
        "error: cannot resume from step 33, t = 0.1 s, without all of " + folder + "/" + name +
            ": it is missing\n  Put the file back, resume from an earlier checkpoint, or start the case anew: terp "
            "run " +
            folder + "/case.toml -o NEW_FOLDER\n");
    EXPECT_EQ(names_in(folder), before);
  }
  const std::string ledger = text_of(whole + "/ledger.csv");
  write_text(whole + "/ledger.csv", ledger.substr(0, ledger.find("\n0.06") + 1));
  EXPECT_THAT(test::terp({"resume", whole}).err, HasSubstr("/ledger.csv: it holds 6 rows up to there, 11 are due\n"));
  write_text(whole + "/ledger.csv", ledger);
  succeeded(test::terp({"resume", whole, "-q", "-j", "1"}));
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

TEST_F(Resume, WhereFramesWereCutNamesThemAndGoesOn)
{
  const std::string folder = scratch.path() + "/cut", cut = folder + "/frames/points_00001.vtkhdf";
  succeeded(run_column(whole, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}", "--set",
                                  "output.fields.every=0.05", "--set", "output.mesh=true"}));
  std::filesystem::remove(whole + last_checkpoint);
  std::filesystem::copy(whole, folder, std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder + "/frames/points_00000.vtkhdf");
  for (const std::string& path : {cut, folder + "/mesh.vtkhdf"})
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_THAT(succeeded(test::terp({"resume", folder, "-q", "-j", "1"})).err,
      AllOf(HasSubstr("points_00000.vtkhdf is missing; the run goes on without it"),
          HasSubstr("warning: " + cut + " is damaged; the run goes on without it: cannot read " + cut),
          HasSubstr("warning: " + folder + "/mesh.vtkhdf is damaged; it is written again")));
  auto expected = frames_of(whole);
  expected.erase("points_00000.vtkhdf");
  const auto seen = frames_of(folder);
  expected["points_00001.vtkhdf"] = seen.at("points_00001.vtkhdf");
  EXPECT_TRUE(seen == expected);
  EXPECT_TRUE(text_of(folder + "/mesh.vtkhdf") == text_of(whole + "/mesh.vtkhdf"));
  EXPECT_THAT(text_of(folder + "/results.vtkhdf.series"), Not(HasSubstr("points_00001")));
  EXPECT_THAT(test::terp({"export", folder, "-o", scratch.path() + "/csv"}).err,
      HasSubstr("warning: " + cut + " is left out: cannot read " + cut));
}

TEST_F(Resume, WithAFileOfAnotherRunOfTheSameSizeIsRefused)
{
  const std::string other = scratch.path() + "/other";
  succeeded(run_column(folder, {"-q"}));
  succeeded(run_column(other, {"-q", "--set", "material.clay.eta=40"}));
  for (const std::string name : {"/frames/points_00000.vtkhdf", "/history.csv", "/ledger.csv"}) {
    const std::string ours = text_of(folder + name);
    write_text(folder + name, text_of(other + name));
    const auto before = names_in(folder);
    EXPECT_THAT(error_with(1, test::terp({"resume", folder})),
        AllOf(StartsWith("error: cannot resume from step 66, t = 0.2 s: " + folder + name + " is "),
            HasSubstr("of another "),
            HasSubstr("\n  Put a copy of it back, or start the case anew: terp run " + folder +
                      "/case.toml -o NEW_FOLDER\n  Nothing was changed")));
    EXPECT_EQ(names_in(folder), before);
    EXPECT_EQ(text_of(folder + name), text_of(other + name));
    write_text(folder + name, ours);
  }
  succeeded(test::terp({"resume", folder, "-q"}));
}

void edit_case(const std::string& folder, const std::string& from, const std::string& to)
{
  std::string text = text_of(folder + "/case.toml");
  write_text(folder + "/case.toml", text.replace(text.find(from), from.size(), to));
}

TEST_F(Resume, OfACaseThatWasChangedIsRefusedWithWhatChanged)
{
  succeeded(run_column(folder, {"-q"}));
  edit_case(folder, "[5, 5]", "[4, 4]");
  edit_case(folder, "eta = 50.0", "eta = 40.0  # softer");
  const auto before = names_in(folder);
  EXPECT_EQ(error_with(1, test::terp({"resume", folder})),
      "error: cannot resume from step 66: " + folder +
          "/case.toml was changed since the run began\n"
          "  body[0].points_per_cell ([5, 5], now [4, 4])\n"
          "  material.clay.eta (50, now 40)\n"
          "  Put back what it began with, or solve the changed case from its start: terp run " +
          folder +
          "/case.toml -o NEW_FOLDER\n"
          "  These may change: title, time.end, time.at_most, output.fields.every, output.checkpoint\n");
  EXPECT_EQ(names_in(folder), before);
  edit_case(folder, "[4, 4]", "5");
  edit_case(folder, "eta = 40.0", "eta = 5.0e1");
  succeeded(test::terp({"resume", folder, "-q"}));
}

TEST_F(Resume, WithALaterEndGoesOnInTheSameTimeStepWithoutGapOrDoubleRows)
{
  succeeded(run_column(folder, {"-q", "--set", "output.fields.every=0.05"}));
  succeeded(run_column(whole, {"-q", "--set", "output.fields.every=0.05", "--set", "time.end=0.4"}));
  edit_case(folder, "end = 0.2", "end = 0.4");
  EXPECT_THAT(succeeded(test::terp({"resume", folder, "-j", "1"})).out,
      AllOf(HasSubstr("step 66 of 132\n"), HasSubstr("  from here on with another time.end (0.2, now 0.4)\n")));
  expect_same_results(whole, folder, "/checkpoint_000000132.h5");  // 0.4 s are just twice as many of the same steps
  edit_case(folder, "end = 0.4", "end = 0.401");
  EXPECT_THAT(test::terp({"resume", folder, "-j", "1"}).out, HasSubstr("step 132 of 133\n"));
  edit_case(folder, "end = 0.401", "end = 0.3");
  EXPECT_EQ(test::terp({"resume", folder}).err,
      "error: cannot resume from step 133, t = 0.403 s: time.end = 0.3 s lies before it\n"
      "  Set a later time.end in case.toml of the folder, or name an earlier checkpoint.\n");
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
