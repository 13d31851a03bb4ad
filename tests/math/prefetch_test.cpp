#include "math/prefetch.hpp"
#include "support/test.hpp"

namespace prefetch_test {

TEST(Prefetch, LeavesNumbersAlone)
{
  std::vector<Real> numbers(100, 3.5);
  prefetch(numbers.data(), 100);
  prefetch(numbers.data() + 3, 97);
  EXPECT_EQ(numbers, std::vector<Real>(100, 3.5));
}

}  // namespace prefetch_test
