#include "os/turn.hpp"
#include "support/test.hpp"
#include <atomic>
#include <chrono>
#include <thread>

namespace turn_test {

struct Waiting {};

TEST(Turn, IsOfOneThreadAtATime)
{
  std::atomic<bool> tries = false, had_its_turn = false;
  std::thread other;
  {
    const Turn<Waiting> turn, again;
    other = std::thread([&] {
      tries = true;
      const Turn<Waiting> its_own;
      had_its_turn = true;
    });
    while (!tries) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(had_its_turn);
  }
  other.join();
  EXPECT_TRUE(had_its_turn);
}

}  // namespace turn_test
