#include "os/threads.hpp"
#include "support/without_threads.hpp"
#include "support/test.hpp"
#include <chrono>

namespace threads_test {

TEST(Threads, WhereTheSystemGrantsNoneTheCallerDoesTheWork)
{
  const int status = status_without_threads([] {
    Threads threads(4);
    int n = 0;
    threads.for_each_chunk(7, [&](Index, int) { ++n; });
    return 10 * threads.count() + n;
  });
  if (status < 0) GTEST_SKIP() << "the limit of threads cannot be set here";
  EXPECT_EQ(status, 17);
}

class EveryThreadCount : public TestWithParam<int> {};

TEST_P(EveryThreadCount, DoesEveryChunkExactlyOnce)
{
  Threads threads(GetParam());
  EXPECT_EQ(threads.count(), GetParam());
  for (const Index n_chunks : {0, 1, 2, 3, 7, 8, 9, 64, 1000, 100003}) {
    std::vector<std::atomic<int>> visits(n_chunks);
    threads.for_each_chunk(n_chunks, [&](Index chunk, int) { visits[chunk].fetch_add(1); });
    for (Index chunk = 0; chunk < n_chunks; ++chunk)
      ASSERT_EQ(visits[chunk].load(), 1) << "chunk " << chunk << " of " << n_chunks;
  }
}

TEST_P(EveryThreadCount, ReturnsOnlyWhenAllIsDone)
{
  Threads threads(GetParam());
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::atomic<int> done{0};
    threads.for_each_chunk(16, [&](Index chunk, int) {
      if (chunk % 5 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
      done.fetch_add(1);
    });
    ASSERT_EQ(done.load(), 16);
  }
}

TEST_P(EveryThreadCount, CoversARangeWithoutGapOrOverlap)
{
  Threads threads(GetParam());
  for (const Index n : {1, 9, 10, 11, 1234}) {
    std::vector<int> visits(n, 0);
    std::vector<Index> begin_of_chunk(Threads::n_chunks(n, 10), -1);
    threads.for_each_range(n, 10, [&](Index begin, Index end, Index chunk, int) {
      begin_of_chunk[chunk] = begin;
      for (Index k = begin; k < end; ++k) ++visits[k];
    });
    EXPECT_THAT(visits, Each(1));
    for (std::size_t chunk = 0; chunk < begin_of_chunk.size(); ++chunk)
      EXPECT_EQ(begin_of_chunk[chunk], static_cast<Index>(10 * chunk));
  }
}

TEST_P(EveryThreadCount, GivesTheSameBits)
{
  const auto sum_of_roots = [](int n_threads) {
    Threads threads(n_threads);
    std::vector<Real> partial(Threads::n_chunks(5000, 37), 0.0);
    threads.for_each_range(5000, 37, [&](Index begin, Index end, Index chunk, int) {
      for (Index k = begin; k < end; ++k) partial[chunk] += std::sqrt(k + 0.1);
    });
    Real total = 0.0;
    for (const Real part : partial) total += part;
    return total;
  };
  EXPECT_EQ(sum_of_roots(GetParam()), sum_of_roots(1));
}

TEST_P(EveryThreadCount, WakesSleepersForTheNextJob)
{
  if (GetParam() == 1) return;  // nobody to wake
  Threads threads(GetParam());
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // far longer than the workers spin
  const auto caller = std::this_thread::get_id();
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  std::atomic<bool> helped{false};
  threads.for_each_chunk(100, [&](Index, int) {
    if (std::this_thread::get_id() != caller) helped = true;
    while (!helped && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
  });
  EXPECT_TRUE(helped) << "the caller had to do all the work";
}

TEST_P(EveryThreadCount, AThreadThatIsHeldUpKeepsTheOthersFromOneChunkOnly)
{
  if (GetParam() == 1) return;  // no others
  Threads threads(GetParam());
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  std::atomic<int> done{0};
  bool all_others_done = false;
  threads.for_each_chunk(64, [&](Index chunk, int) {
    while (chunk == 0 && done.load() < 63 && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
    if (chunk == 0) all_others_done = done.load() == 63;
    done.fetch_add(1);
  });
  EXPECT_TRUE(all_others_done);
}

INSTANTIATE_TEST_SUITE_P(Counts, EveryThreadCount, testing::Range(1, 9));

TEST(Threads, DoAHundredThousandTinyJobsWithoutStandingStill)
{
  for (const int n_threads : {2, 4}) {
    Threads threads(n_threads);
    std::array<std::atomic<std::int64_t>, 3> total{};
    for (int job = 0; job < 50000; ++job)
      threads.for_each_chunk(3, [&](Index chunk, int) { total[chunk].fetch_add(job); });
    for (const auto& sum : total) EXPECT_EQ(sum.load(), 50000LL * 49999 / 2);
  }
}

TEST(Threads, SeeWhatTheCallerWroteBetweenJobs)
{
  Threads threads(4);
  std::vector<int> value(64, 0);
  for (int job = 1; job <= 2000; ++job) {
    int wrong = 0;
    for (int& v : value) wrong += v != job - 1;
    ASSERT_EQ(wrong, 0);
    threads.for_each_chunk(64, [&](Index chunk, int) { value[chunk] = job; });
  }
}

TEST(Threads, LeaveWithoutEverHavingWorked)
{
  for (int repeat = 0; repeat < 200; ++repeat) Threads threads(1 + repeat % 8);
}

TEST(AvailableProcessors, IsAtLeastOneAndAtMostTheMachineHas)
{
  EXPECT_GE(available_processors(), 1);
  EXPECT_LE(available_processors(), static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace threads_test
