#include "math/tables.hpp"
#include "support/random.hpp"

namespace tables_test {

using Packs = std::array<Pack, pack_width>;

Packs random_packs(std::uint64_t seed)
{
  Random random(seed);
  Packs packs;
  for (Pack& pack : packs) {
    alignas(64) Real numbers[pack_width];
    for (Real& number : numbers) number = std::exp(random.between(-30.0, 30.0)) * random.between(-1.0, 1.0);
    pack = Pack::load(numbers);
  }
  return packs;
}

TEST(Tables, TurningMakesLanesOfPacks)
{
  const Packs packs = random_packs(1), turned = turn(packs);
  for (int k = 0; k < pack_width; ++k)
    for (int c = 0; c < pack_width; ++c) EXPECT_EQ(turned[c][k], packs[k][c]) << "pack " << k << ", lane " << c;
}

TEST(Tables, EightSumsHaveTheBitsOfEachAlone)
{
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Packs packs = random_packs(seed);
    const Pack sums = sum_eight(packs);
    for (int k = 0; k < pack_width; ++k) ASSERT_EQ(sums[k], sum(packs[k])) << "pack " << k;
  }
}

TEST(Tables, SomeNumbersAreReadAndWrittenAtAnyAddress)
{
  for (int n = 1; n <= pack_width; ++n) {
    std::array<Real, pack_width + 2> from, to{};
    for (std::size_t k = 0; k < from.size(); ++k) from[k] = static_cast<Real>(k + 1);
    const Pack some = load_some(from.data() + 1, n);
    for (int k = 0; k < pack_width; ++k) EXPECT_EQ(some[k], k < n ? from[k + 1] : 0.0);
    store_some(some, to.data() + 1, n);
    for (int k = 0; k < pack_width + 2; ++k) EXPECT_EQ(to[k], k >= 1 && k <= n ? from[k] : 0.0);
  }
}

TEST(Tables, LookingUpFindsTheNumberOfEachPlace)
{
  Random random(2);
  alignas(64) Real table[16];
  for (Real& number : table) number = random.between(-1.0, 1.0);
  for (int first = 0; first < 16; ++first) {
    alignas(64) Real numbers[pack_width];
    for (int lane = 0; lane < pack_width; ++lane) numbers[lane] = (first + 5 * lane) % 16;
    const Pack places = Pack::load(numbers) + Pack(place_base), found = look_up(table, places);
    for (int lane = 0; lane < pack_width; ++lane) {
      EXPECT_EQ(entry_at(places[lane]), (first + 5 * lane) % 16);
      EXPECT_EQ(found[lane], table[(first + 5 * lane) % 16]);
    }
  }
}

}  // namespace tables_test
