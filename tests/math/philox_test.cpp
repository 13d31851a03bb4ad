// Numbers by counting, against the vectors that their authors publish.
#include "math/philox.hpp"

#include "support/test.hpp"

namespace philox_test {

TEST(Philox, GivesTheKnownAnswers)
{
  // Random123, kat_vectors, philox4x32 10: counter, key, result.
  EXPECT_THAT(philox({0, 0, 0, 0}, {0, 0}), ElementsAre(0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u));
  constexpr std::uint32_t ones = 0xffffffffu;
  EXPECT_THAT(
      philox({ones, ones, ones, ones}, {ones, ones}), ElementsAre(0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu));
  EXPECT_THAT(philox({0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u}, {0xa4093822u, 0x299f31d0u}),
      ElementsAre(0xd16cfe09u, 0x94fdcceb, 0x5001e420u, 0x24126ea1u));
}

TEST(Philox, UniformNumbersLieStrictlyBetweenZeroAndOne)
{
  EXPECT_NEAR(philox_uniform({0, 0, 0, 0}, {0, 0}), 0x6627e8d5p-32, 0x1p-32) << "the first word leads";
  Real sum = 0.0, squares = 0.0;
  constexpr int n = 20000;
  for (std::uint32_t k = 0; k < n; ++k) {
    const Real u = philox_uniform({k, 1, 2, 3}, {4, 5});
    ASSERT_GT(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u, squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / n)) << "four standard errors";
  EXPECT_NEAR(squares / n, 1.0 / 3.0, 4.0 * std::sqrt(4.0 / 45.0 / n));
}

}  // namespace philox_test
