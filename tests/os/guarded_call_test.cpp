#include "os/guarded_call.hpp"
#include "support/test.hpp"

#include <cfenv>
#include <csignal>
#include <cstdio>
#include <thread>

namespace guarded_call_test {

std::string guarded(void (*f)(void*), void* argument = nullptr)
{
  return call_guarded(
      f, [](void*, const char* why, char* text, std::size_t n) { std::snprintf(text, n, "it %s", why); }, argument);
}

TEST(GuardedCall, ThatReturnsIsSilent)
{
  int called = 0;
  EXPECT_EQ(guarded([](void* n) { ++*static_cast<int*>(n); }, &called), "");
  EXPECT_EQ(called, 1);
}

TEST(GuardedCall, ThatFailsComesBackWithWords)
{
  EXPECT_EQ(guarded([](void*) { std::raise(SIGSEGV); }), "used memory that is not its own (SIGSEGV)");
  EXPECT_EQ(
      guarded([](void*) { std::raise(SIGILL); }), "has an instruction that this processor does not know (SIGILL)");
  EXPECT_EQ(guarded([](void*) { throw std::runtime_error("no convergence"); }), "threw an exception: no convergence");
  EXPECT_EQ(guarded([](void*) { throw 3; }), "threw an exception");
}

TEST(GuardedCall, ThatChangesTheRoundingChangesItForNobodyElse)
{
  EXPECT_EQ(guarded([](void*) { std::fesetround(FE_UPWARD); }), "");
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(GuardedCallDeathTest, ThatEndsTheProgramIsDescribed)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(guarded([](void*) { std::exit(0); }), testing::ExitedWithCode(3), "error: it ended the program");
  EXPECT_EXIT(guarded([](void*) { std::abort(); }), testing::ExitedWithCode(3), "error: it called abort");
}

TEST(GuardedCallDeathTest, ThatFailsInTheCLibraryEndsTheProgram)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(guarded([](void* a) { std::puts(static_cast<const char*>(a)); }, reinterpret_cast<void*>(8)),
      testing::ExitedWithCode(3), "error: it used memory that is not its own");
}

TEST(GuardedCallDeathTest, ThatEndsTheProgramOnSeveralThreadsIsDescribedOnce)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto end_on_threads = [] {
    std::vector<std::thread> threads;
    for (int k = 0; k < 4; ++k) threads.emplace_back([] { guarded([](void*) { std::exit(0); }); });
    for (std::thread& thread : threads) thread.join();
  };
  EXPECT_EXIT(end_on_threads(), testing::ExitedWithCode(3), "^error: it ended the program[^:]*$");
}

TEST(GuardedCallDeathTest, LeavesSignalsOfOtherCodeAsTheyAre)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer has a handler of its own";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((guarded([](void*) {}), std::raise(SIGSEGV)), testing::KilledBySignal(SIGSEGV), "");
}

}  // namespace guarded_call_test
