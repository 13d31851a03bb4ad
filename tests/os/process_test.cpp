#include "os/process.hpp"
#include "support/test.hpp"
#include <chrono>
#include <csignal>

namespace process_test {

TEST(RunProcess, GivesOutputOfBothStreamsAndTheStatus)
{
  const auto result = run_process({"sh", "-c", "echo one; echo two >&2; exit 3"}, 10.0);
  EXPECT_TRUE(result.found);
  EXPECT_EQ(result.status, 3);
  EXPECT_FALSE(result.succeeded());
  EXPECT_EQ(result.output, "one\ntwo\n");
}

TEST(RunProcess, HandsArgumentsOverAsTheyAre)
{
  EXPECT_EQ(run_process({"printf", "%s|", "a b", "$HOME", "; rm x", "'"}, 10.0).output, "a b|$HOME|; rm x|'|");
}

TEST(RunProcess, AddsToTheEnvironment)
{
  EXPECT_EQ(run_process({"sh", "-c", "echo $TERP_TEST$HOME"}, 10.0, {"TERP_TEST=x", "HOME=/y"}).output, "x/y\n");
}

TEST(RunProcess, SaysThatAProgramIsNotThere)
{
  const auto result = run_process({"no-such-program-here"}, 10.0);
  EXPECT_FALSE(result.found);
  EXPECT_FALSE(result.succeeded());
}

TEST(RunProcess, EndsAProgramWhoseTimeIsOver)
{
  const auto start = std::chrono::steady_clock::now();
  const auto result = run_process({"sleep", "60"}, 0.3);
  EXPECT_TRUE(result.timed_out);
  EXPECT_FALSE(result.succeeded());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(RunProcess, KeepsTheEndOfALongOutput)
{
  const auto result = run_process({"sh", "-c", "i=0; while [ $i -lt 20000 ]; do echo line $i; i=$((i+1)); done"}, 60.0);
  EXPECT_TRUE(result.succeeded());
  EXPECT_LE(result.output.size(), 16384u);
  EXPECT_THAT(result.output, EndsWith("line 19999\n"));
}

TEST(RunProcess, LetsAnInterruptEndTheProgramThoughWeIgnoreIt)
{
  const auto before = std::signal(SIGINT, SIG_IGN);
  const auto result = run_process({"sh", "-c", "kill -INT $$; sleep 60"}, 10.0);
  std::signal(SIGINT, before);
  EXPECT_EQ(result.signal, SIGINT);
}

}  // namespace process_test
