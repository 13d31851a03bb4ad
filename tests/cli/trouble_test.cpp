// Disks and folders that fail under a run: what it says, and that nothing earlier is harmed (docs/reliability.md).
#include "cli/same_results.hpp"
#include "io/files/small_disk.hpp"
#include "support/without_threads.hpp"
#include <csignal>
#include <fcntl.h>
#include <pty.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trouble_test {

namespace fs = std::filesystem;

/// As long as it lives, no program that is started may make a file longer than n_bytes (ulimit -f).
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t n_bytes)
  {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = n_bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

const std::vector<std::string> often{
    "-q", "--set", "output.fields.every=0.02", "--set", "output.checkpoint.every=0.02"};

std::string said_without_threads(std::vector<std::string> words)
{
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms::all);  // the child is another user
  words.insert(words.begin(), program());
  words.insert(words.end(), {"-o", "run"});
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  status_without_threads([&] {
    const int file = ::open((scratch.path() + "/err").c_str(), O_WRONLY | O_CREAT, 0600);
    if (::dup2(file, STDERR_FILENO) < 0 || ::chdir(scratch.path().c_str()) != 0) return 126;
    return ::execv(argv[0], argv.data());
  });
  return text_of(scratch.path() + "/err");
}

struct Trouble : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  const std::string whole = scratch.path() + "/whole";
};

TEST_F(Trouble, MissingThreadsAreAWarningOfEveryCommandThatSolves)
{
  const std::string warning =
      "warning: the system granted 1 of 2 threads (ulimit -u); the results are the same, the run takes longer\n";
  for (const std::string command : {"run", "stability"}) {
    std::vector<std::string> words = column_command(command, {"-q"});
    std::ranges::replace(words, std::string("1"), std::string("2"));  // -j 2
    if (command == "stability") words.insert(words.end(), {"--windows", "3", "--to", "1.5"});
    const std::string said = said_without_threads(words);
    EXPECT_THAT(said, HasSubstr(warning)) << command;
    EXPECT_EQ(said.find(warning), said.rfind(warning)) << command << " says it once";
  }
}

TEST_F(Trouble, AReadOnlyDiskIsRefusedBeforeAnythingRuns)
{
  const SmallDisk disk(1 << 20);
  if (!disk.is_there()) GTEST_SKIP() << "needs the right to mount a tmpfs";
  ASSERT_EQ(::mount("none", disk.path().c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0);
  const Finished f = run_column(disk.path() + "/run");
  EXPECT_EQ(f.status, 1);
  EXPECT_EQ(f.out, "");
  EXPECT_EQ(f.err, "error: cannot make the run folder " + disk.path() + "/run: Read-only file system\n");
}

TEST_F(Trouble, AFileThatMayGrowNoMoreIsAnErrorAndTheRunCanGoOn)
{
  succeeded(run_column(folder, with(often, {"--set", "time.end=0.1"})));
  std::string text = text_of(folder + "/case.toml");
  write_text(folder + "/case.toml", text.replace(text.find("end = 0.1"), 9, "end = 0.2"));
  Finished f;
  {
    const FileSizeLimit limit(40 << 10);  // more than the tables, less than a frame
    f = test::terp({"resume", folder, "-q", "-j", "1"});
  }
  EXPECT_EQ(f.status, 1);
  EXPECT_THAT(f.err, AllOf(StartsWith("error: cannot write " + folder + "/frames/points_"), HasSubstr("File too large"),
                         HasSubstr("Earlier results are intact, up to the checkpoint at t = 0.1"),
                         HasSubstr("terp resume " + folder)));
  succeeded(test::terp({"resume", folder, "-q", "-j", "2"}));
  succeeded(run_column(whole, often));
  expect_same_results(whole, folder, "/checkpoint_000000066.h5");
}

TEST_F(Trouble, ResultsThatCannotBeWrittenAnyMoreEndTheRunAndItCanGoOn)
{
  const std::string aside = scratch.path() + "/aside";
  const std::vector<std::string> more{
      "--set", "time.end=0.6", "--set", "output.fields.every=0.02", "--set", "output.checkpoint.every=0.02"};
  Process running(with(longer_run(folder, "1"), more));
  wait_for_checkpoint(folder);
  fs::rename(folder + "/frames", aside);
  write_text(folder + "/frames", "");
  const std::string err = error_with(1, running.wait());
  // Make the folder, open, write or rename: as far as the writing of a frame had come.
  EXPECT_THAT(
      err, AllOf(ContainsRegex("error: cannot [a-z ]+ " + folder + "/frames"), HasSubstr("terp resume " + folder)));

  fs::remove(folder + "/frames");
  fs::rename(aside, folder + "/frames");
  succeeded(test::terp({"resume", folder, "-q", "-j", "2"}));
  succeeded(test::terp(with(longer_run(whole, "1"), more)));
  expect_same_results(whole, folder, "/checkpoint_000000396.h5");
}

TEST_F(Trouble, AClosedTerminalStopsTheRunWithACheckpoint)
{
  const std::vector<std::string> words = longer_run(folder, "1");
  std::string program = test::program();
  std::vector<char*> arguments{program.data()};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int terminal = -1;
  const pid_t pid = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (pid == 0) {
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  wait_for_rows(folder);
  ::close(terminal);
  int status = -1;
  ASSERT_EQ(::waitpid(pid, &status, 0), pid);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << status;
  const auto summary = text_of(folder + "/summary.json");
  EXPECT_THAT(summary, HasSubstr("\"finished\": false"));
  EXPECT_TRUE(newest_good_checkpoint(folder).image);
}

TEST_F(Trouble, ARunThatWasStartedWithNohupOutlivesItsTerminal)
{
  const auto before = std::signal(SIGHUP, SIG_IGN);  // what nohup does
  Process running(with(longer_run(folder, "1"), {"--set", "time.end=0.6"}));
  std::signal(SIGHUP, before);
  wait_for_rows(folder);
  running.send(SIGHUP);
  succeeded(running.wait());
}

TEST_F(Trouble, APipeThatNobodyReadsDoesNotEndTheRun)
{
  std::string command = program();
  for (const std::string& word : column_command("run", {"-o", folder})) command += ' ' + word;
  EXPECT_EQ(std::system(("bash -c '" + command + " | true; exit ${PIPESTATUS[0]}'").c_str()), 0);
  EXPECT_THAT(text_of(folder + "/summary.json"), HasSubstr("\"finished\": true"));
}

TEST_F(Trouble, AnAnswerThatCannotBePrintedIsAnErrorButARunIsSolved)
{
  const auto status_of = [&](const std::string& words) {
    return WEXITSTATUS(
        std::system((program() + " " + words + " > /dev/full 2> " + scratch.path() + "/errors").c_str()));
  };
  for (const std::string words : {"list", "--help", "explain mpm_gp"}) {
    EXPECT_EQ(status_of(words), 1) << words;
    EXPECT_EQ(
        text_of(scratch.path() + "/errors"), "error: what was to be printed is not complete: No space left on device\n")
        << words;
  }
  std::string run;
  for (const std::string& word : column_command("run", {"-o", folder})) run += word + ' ';
  EXPECT_EQ(status_of(run), 0);
  EXPECT_THAT(text_of(scratch.path() + "/run/summary.json"), HasSubstr("\"finished\": true"));
}

TEST_F(Trouble, AWordThatCannotBeWrittenChangesNoStatus)
{
  std::string run;
  for (const std::string& word : column_command("run", {"-q", "--set", "output.history.every=0.3", "-o", folder}))
    run += word + ' ';
  const std::string wrong = scratch.path() + "/wrong.stix";
  std::ofstream(wrong) << "no zip";
  for (const std::string& words : {run, "report " + folder + " -o " + scratch.path() + "/page.html",
           "export " + folder + " --profile " + scratch.path() + "/profile.csv", "import " + wrong,
           "check " + scratch.path() + "/none.toml", "frobnicate " + wrong}) {
    const auto status_with = [&](const std::string& stream) {
      if (words == run) fs::remove_all(folder);
      const std::string line = program() + " " + words + " > /dev/null " + stream;
      return WEXITSTATUS(std::system(("bash -c 'trap \"\" PIPE; " + line + "'").c_str()));
    };
    const int good = status_with("2> /dev/null");
    EXPECT_LT(good, 3) << words;
    EXPECT_EQ(status_with("2> /dev/full"), good) << words;
    EXPECT_EQ(status_with("2> >(exec 0<&-; true)"), good) << words;
    if (words == run || words.starts_with("report") || words.starts_with("export")) {
      EXPECT_EQ(status_with("> /dev/full 2> /dev/full"), good) << words;
    }
  }
}

TEST_F(Trouble, ClosedStandardStreamsLeaveTheTablesAsTheyAre)
{
  const auto run = [&](const std::string& name, const std::string& redirections) {
    std::string command = program();
    for (const std::string& word : column_command("run", {"-v", "-o", scratch.path() + "/" + name}))
      command += ' ' + word;
    return std::system((command + redirections).c_str());
  };
  ASSERT_EQ(run("open", " > /dev/null 2> /dev/null"), 0);
  for (const std::string closed : {" <&- >&-", " <&- >&- 2>&-", " >&- 2> /dev/null"}) {
    const std::string name = "closed" + std::to_string(closed.size());
    EXPECT_EQ(run(name, closed), 0) << closed;
    for (const char* table : {"/ledger.csv", "/history.csv", "/case.toml"})
      EXPECT_EQ(text_of(scratch.path() + "/" + name + table), text_of(scratch.path() + "/open" + table))
          << table << closed;
  }
}

TEST_F(Trouble, WhatAKillLeavesUnderTemporaryNamesIsRemovedByResume)
{
  succeeded(run_column(folder, often));
  for (const char* name : {"/frames/points_00003.vtkhdf.tmp", "/checkpoint_000000033.h5.tmp"})
    write_text(folder + name, "cut short");
  succeeded(test::terp({"resume", folder, "-q", "-j", "1"}));
  for (const std::string& in : {folder, folder + "/frames"})
    for (const std::string& name : names_in(in)) EXPECT_FALSE(name.ends_with(".tmp")) << name;
}

}  // namespace trouble_test
