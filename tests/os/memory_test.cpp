#include "os/memory.hpp"
#include "support/test.hpp"

namespace memory_test {

struct Pair {
  double a = 0.0, b = 0.0;
};

long resident_pages()
{
  long all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident;
}

TEST(ZeroedArray, IsZeroUntilItIsWritten)
{
  ZeroedArray<Pair> array(1000);
  ASSERT_EQ(array.size(), 1000u);
  for (const Pair& pair : array) ASSERT_EQ(pair.a + pair.b, 0.0);
  array[999].b = 3.0;
  EXPECT_EQ(array[999].b, 3.0);
  array.make_anew(2000);
  ASSERT_EQ(array.size(), 2000u);
  EXPECT_EQ(array[999].b, 0.0);
}

TEST(ZeroedArray, MayBeEmpty)
{
  const ZeroedArray<Pair> none, empty(0);
  EXPECT_EQ(none.size() + empty.size(), 0u);
  EXPECT_EQ(empty.begin(), empty.end());
}

TEST(ZeroedArray, TakesMemoryOnlyWhereItIsWritten)
{
  const long before = resident_pages();
  ZeroedArray<Pair> array(std::size_t{1} << 26);  // 1 GiB
  array[std::size_t{1} << 25].a = 1.0;
  EXPECT_LT(resident_pages() - before, 1000);  // 4 MiB
  EXPECT_EQ(array[(std::size_t{1} << 25) + 1].a, 0.0);
}

}  // namespace memory_test
