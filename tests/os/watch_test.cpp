#include "os/watch.hpp"
#include "support/test.hpp"

#include <chrono>

namespace watch_test {

void sleep_s(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

TEST(Watch, TellsOfAPauseOnceForEachTimeThatItDoubled)
{
  std::mutex mutex;
  std::vector<double> told;
  {
    Watch watch(0.1, [&](double seconds) {
      const std::lock_guard lock(mutex);
      told.push_back(seconds);
    });
    sleep_s(0.9);
  }
  ASSERT_GE(told.size(), 2U);
  EXPECT_LE(told.size(), 4U) << "at 0.1, 0.2, 0.4 and 0.8 s";
  EXPECT_NEAR(told[0], 0.1, 0.02);
  EXPECT_NEAR(told[1], 0.2, 0.02);
}

TEST(Watch, IsSilentWhileItHears)
{
  std::atomic<int> told = 0;
  Watch watch(0.5, [&](double) { ++told; });
  for (int k = 0; k < 20; ++k) {
    sleep_s(0.05);
    watch.hear();
  }
  EXPECT_EQ(told, 0);
}

TEST(Watch, WaitsLongerAfterALongPause)
{
  std::atomic<int> told = 0;
  Watch watch(0.05, [&](double) { ++told; });
  watch.hear();
  sleep_s(0.6);
  watch.hear();
  sleep_s(0.03);
  const int before = told;
  sleep_s(0.3);
  EXPECT_GE(before, 1);
  EXPECT_EQ(told, before) << "20 times 0.6 s are not over";
}

}  // namespace watch_test
