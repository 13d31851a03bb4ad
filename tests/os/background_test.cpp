#include "os/background.hpp"
#include "support/without_threads.hpp"
#include "support/test.hpp"
#include <atomic>

namespace background_test {

TEST(Background, SaysWhatToDoWhereTheSystemGrantsNoThread)
{
  const int status = status_without_threads([] {
    try {
      Background background(1);
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      const bool clear = text.starts_with("cannot start the thread that writes results: ") &&
                         text.find("(ulimit -u)") != std::string::npos &&
                         text.find("raise the limit") != std::string::npos;
      return clear ? 3 : 2;
    }
    return 1;
  });
  if (status < 0) GTEST_SKIP() << "the limit of threads cannot be set here";
  EXPECT_EQ(status, 3);
}

TEST(Background, DoesTheTasksInTheirOrder)
{
  std::vector<int> done;
  Background background(2);
  for (int k = 0; k < 5; ++k) background.add([&done, k] { done.push_back(k); });
  background.finish();
  EXPECT_THAT(done, ElementsAre(0, 1, 2, 3, 4));
}

TEST(Background, FinishesWhatItWasGivenBeforeItEnds)
{
  std::atomic<int> n{0};
  {
    Background background(100);
    for (int k = 0; k < 50; ++k) background.add([&n] { ++n; });
  }
  EXPECT_EQ(n, 50);
}

TEST(Background, ThrowsTheErrorOfATaskAtTheNextCallAndDropsTheTasksBehindIt)
{
  std::atomic<bool> go{false}, behind{false};
  Background background(8);
  background.add([&] {
    while (!go) std::this_thread::yield();
    throw std::runtime_error("disk full");
  });
  background.add([&] { behind = true; });
  go = true;
  EXPECT_THROW(background.finish(), std::runtime_error);
  background.finish();
  EXPECT_FALSE(behind);
}

TEST(Background, MakesTheGiverWaitWhenTooMuchIsWaiting)
{
  std::atomic<int> started{0};
  Background background(1);
  for (int k = 0; k < 20; ++k) {
    background.add([&] { ++started; });
    EXPECT_GE(started, k - 1);  // one waits, one may be at work
  }
  background.finish();
}

}  // namespace background_test
