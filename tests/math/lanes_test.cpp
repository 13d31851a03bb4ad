#include "math/lanes.hpp"
#include "support/random.hpp"

namespace lanes_test {

using Table = std::array<std::array<Real, 4>, pack_width>;

Table random_table(std::uint64_t seed)
{
  Random random(seed);
  Table table;
  for (auto& row : table)
    for (Real& value : row) value = random.between(-1.0, 1.0);
  return table;
}

TEST(Lanes, LaneCOfPackKIsNumberKOfPlaceC)
{
  const Table table = random_table(1);
  const auto lanes = to_lanes([&](int c) { return table[c].data(); });
  for (int c = 0; c < pack_width; ++c)
    for (int k = 0; k < 4; ++k) EXPECT_EQ(lanes[k][c], table[c][k]) << "place " << c << ", number " << k;
}

TEST(Lanes, TurnBackToWhereTheyCameFrom)
{
  const Table table = random_table(2);
  Table back{};
  from_lanes(to_lanes([&](int c) { return table[c].data(); }), [&](int c) { return back[c].data(); });
  EXPECT_EQ(back, table);
}

TEST(Lanes, AreReadFromAndWrittenToAnyAddress)
{
  std::array<Real, 4 * pack_width + 1> from, to{};
  for (std::size_t k = 0; k < from.size(); ++k) from[k] = static_cast<Real>(k);
  from_lanes(to_lanes([&](int c) { return from.data() + 1 + 4 * c; }), [&](int c) { return to.data() + 1 + 4 * c; });
  for (std::size_t k = 1; k < from.size(); ++k) EXPECT_EQ(to[k], from[k]);
  EXPECT_EQ(to[0], 0.0);
}

TEST(Lanes, FourSumsHaveTheBitsOfEachAlone)
{
  Random random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    std::array<Pack, 4> packs;
    for (Pack& pack : packs) {
      alignas(64) Real numbers[pack_width];
      for (Real& number : numbers) number = std::exp(random.between(-30.0, 30.0)) * random.between(-1.0, 1.0);
      pack = Pack::load(numbers);
    }
    const auto sums = sum_each(packs);
    for (int k = 0; k < 4; ++k) ASSERT_EQ(sums[k], sum(packs[k])) << "pack " << k;
  }
}

TEST(Lanes, NumbersOfPacksStandOneAfterTheOther)
{
  auto packs = zero_packs<3>();
  for (int k = 0; k < 3; ++k) packs[k] = lane_numbers() + Pack(pack_width * k);
  for (int k = 0; k < 3 * pack_width; ++k) EXPECT_EQ(numbers_of(packs)[k], k);
}

}  // namespace lanes_test
