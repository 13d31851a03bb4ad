#include "os/thread_time.hpp"

#include "support/test.hpp"

#include <thread>

namespace thread_time_test {

using Clock = std::chrono::steady_clock;

void work_for(double seconds)
{
  const double begin = thread_seconds();
  const auto late = Clock::now() + std::chrono::seconds(30);
  while (thread_seconds() - begin < seconds && Clock::now() < late) {
  }
}

TEST(ThreadTime, CountsTheWorkOfThisThreadAlone)
{
  const double begin = thread_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_LT(thread_seconds() - begin, 0.05) << "it slept";
  std::thread([] { work_for(0.1); }).join();
  EXPECT_LT(thread_seconds() - begin, 0.05) << "another one worked";
  const auto start = Clock::now();
  work_for(0.1);
  EXPECT_GE(thread_seconds() - begin, 0.1);
  EXPECT_GE(std::chrono::duration<double>(Clock::now() - start).count(), 0.09);
}

}  // namespace thread_time_test
