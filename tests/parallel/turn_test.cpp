// Threads that take turns.
#include "parallel/turn.hpp"
#include "support/test.hpp"
#include <thread>

namespace turn_test {

struct Counting {};

TEST(Turn, IsOfOneThreadAtATime)
{
  int n = 0;  // no atomic: only turns keep the additions apart
  const auto count = [&n] {
    for (int k = 0; k < 100000; ++k) {
      const Turn<Counting> turn, again;
      n = n + 1;
    }
  };
  std::thread other(count);
  count();
  other.join();
  EXPECT_EQ(n, 200000);
}

}  // namespace turn_test
