#include "math/pack.hpp"
#include "support/random.hpp"

namespace pack_test {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

Pack pack_of(const std::array<Real, 8>& a)
{
  alignas(64) std::array<Real, 8> aligned = a;
  return Pack::load(aligned.data());
}

std::array<Real, 8> lanes_of(Pack a)
{
  alignas(64) std::array<Real, 8> lanes;
  a.store(lanes.data());
  return lanes;
}

const std::array<Real, 8> some{3.0, -1.0, 0.5, 7.0, -2.25, 0.0, 11.0, 1e-3};
const std::array<Real, 8> other{-4.0, 2.0, 0.5, 8.0, -3.0, 1.0, 10.0, 1e3};

TEST(Pack, LoadsAndStoresLanesInOrder) { EXPECT_EQ(lanes_of(pack_of(some)), some); }

TEST(Pack, LaneNumbersCountFromZero) { EXPECT_THAT(lanes_of(lane_numbers()), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7)); }

TEST(Pack, ArithmeticActsLaneByLane)
{
  const Pack a = pack_of(some), b = pack_of(other);
  Pack sum_in_place = a, difference_in_place = a, product_in_place = a;
  sum_in_place += b;
  difference_in_place -= b;
  product_in_place *= b;
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ((a + b)[k], some[k] + other[k]);
    EXPECT_EQ((a - b)[k], some[k] - other[k]);
    EXPECT_EQ((a * b)[k], some[k] * other[k]);
    EXPECT_EQ((a / b)[k], some[k] / other[k]);
    EXPECT_EQ((-a)[k], -some[k]);
    EXPECT_EQ(sum_in_place[k], some[k] + other[k]);
    EXPECT_EQ(difference_in_place[k], some[k] - other[k]);
    EXPECT_EQ(product_in_place[k], some[k] * other[k]);
  }
}

TEST(Pack, ComparisonsChooseLaneByLane)
{
  const Pack a = pack_of(some), b = pack_of(other);
  EXPECT_EQ(to_bits(a < b), 0b10101010u);
  EXPECT_EQ(to_bits(a > b), 0b01010001u);
  EXPECT_EQ(to_bits(a <= b), 0b10101110u);
  EXPECT_EQ(to_bits(a >= b), 0b01010101u);
  EXPECT_EQ(to_bits((a < b) & (a > Pack(0.0))), 0b10001000u);
  EXPECT_EQ(to_bits((a < b) | (a > Pack(0.0))), 0b11101111u);
  EXPECT_EQ(to_bits(!(a < b)), 0b01010101u);
  EXPECT_TRUE(any_of(a < b));
  EXPECT_FALSE(any_of(a > Pack(100.0)));
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ(select(a < b, a, b)[k], select(some[k] < other[k], some[k], other[k]));
    EXPECT_EQ(min(a, b)[k], std::fmin(some[k], other[k]));
    EXPECT_EQ(max(a, b)[k], std::fmax(some[k], other[k]));
    EXPECT_EQ(abs(a)[k], std::fabs(some[k]));
  }
}

/// As a < b ? a : b does, alone and in a pack: the order of the two is a part of the bits.
TEST(Pack, MinAndMaxGiveTheSecondNumberWhereNeitherIsLess)
{
  const std::array<Real, 8> first{0.0, -0.0, not_a_number, 1.0, not_a_number, 2.0, -0.0, 3.0};
  const std::array<Real, 8> second{-0.0, 0.0, 1.0, not_a_number, -not_a_number, 2.0, -0.0, 4.0};
  const Pack least = min(pack_of(first), pack_of(second)), most = max(pack_of(first), pack_of(second));
  const auto bits = [](Real a) { return std::bit_cast<std::uint64_t>(a); };
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ(bits(least[k]), bits(k < 7 ? second[k] : first[k]));
    EXPECT_EQ(bits(most[k]), bits(second[k]));
    EXPECT_EQ(bits(least[k]), bits(min(first[k], second[k])));
    EXPECT_EQ(bits(most[k]), bits(max(first[k], second[k])));
  }
}

TEST(Pack, ComparisonsWithWhatIsNoNumberAreFalse)
{
  const Pack a = pack_of({not_a_number, 1.0, not_a_number, 1.0, not_a_number, 1.0, not_a_number, 1.0});
  const Pack zero(0.0), two(2.0);
  for (const Mask m : {(a < two), (a <= two), (zero < a), (zero <= a), (a > zero), (a >= zero), (two > a), (two >= a)})
    EXPECT_EQ(to_bits(m), 0b10101010u);
  EXPECT_EQ(to_bits(!(a < two)), 0b01010101u);
}

TEST(Pack, RootAndFusedProductAreTheSameAsAlone)
{
  const Pack a = pack_of(some), b = pack_of(other), c = pack_of({1e-17, -2.0, 0.25, 1e17, 3.0, -0.5, 1.0, 9.0});
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ(terp::fma(a, b, c)[k], terp::fma(some[k], other[k], c[k]));
    EXPECT_EQ(sqrt(abs(a))[k], std::sqrt(std::fabs(some[k])));
  }
}

TEST(Pack, SumsInTheOrderItPromises)
{
  Real expected = ((1.0 + 1e16) + (3.0 - 1e16)) + ((2.0 + 0.5) + (4.0 + 0.25));
  EXPECT_EQ(sum(pack_of({1.0, 2.0, 3.0, 4.0, 1e16, 0.5, -1e16, 0.25})), expected);
  EXPECT_NE(expected, 1.0 + 2.0 + 3.0 + 4.0 + 1e16 + 0.5 - 1e16 + 0.25) << "the numbers do not tell orders apart";
}

TEST(Pack, RoundsCountsUpToWholePacks)
{
  EXPECT_EQ(round_up_to_pack(0), 0);
  EXPECT_EQ(round_up_to_pack(1), 8);
  EXPECT_EQ(round_up_to_pack(8), 8);
  EXPECT_EQ(round_up_to_pack(25), 32);
}

TEST(Exponential, IsWithin1eMinus15OverItsWholeRange)
{
  Random random(1);
  long double worst = 0.0L;
  for (int k = 0; k < 400000; ++k) {
    const Real x = k % 2 ? random.between(-700.0, 700.0) : random.between(-30.0, 1.0);
    worst = std::max(worst, std::abs(exponential(x) / std::exp(static_cast<long double>(x)) - 1.0L));
  }
  EXPECT_LT(worst, 3e-16L);  // promised 1e-15; measured 1.4e-16, and 3.6e-16 without the last term of the polynomial
}

TEST(Exponential, AgreesWithTheStandardLibraryAtTheEnds)
{
  for (const Real x : {-700.0, -699.99, -1e-300, 0.0, 1e-17, 1.0, 699.99, 700.0})
    EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-15) << "x = " << x;
  EXPECT_EQ(exponential(0.0), 1.0);
}

TEST(Exponential, IsTheSameInAPackAndAlone)
{
  Random random(2);
  for (int k = 0; k < 10000; ++k) {
    std::array<Real, 8> x;
    for (Real& value : x) value = random.between(-750.0, 750.0);
    const auto y = lanes_of(exponential(pack_of(x)));
    for (int lane = 0; lane < 8; ++lane) ASSERT_EQ(y[lane], exponential(x[lane])) << "x = " << x[lane];
  }
}

TEST(Exponential, StaysAtItsLimitsOutsideItsRange)
{
  EXPECT_EQ(exponential(800.0), exponential(700.0));
  EXPECT_EQ(exponential(-1e6), exponential(-700.0));
  EXPECT_EQ(exponential(infinity), exponential(700.0));
  EXPECT_EQ(exponential(-infinity), exponential(-700.0));
}

TEST(Exponential, KeepsNotANumber)
{
  EXPECT_TRUE(std::isnan(exponential(not_a_number)));
  const auto y = lanes_of(exponential(pack_of({0.0, not_a_number, 1.0, 0.0, 0.0, 0.0, 0.0, -not_a_number})));
  EXPECT_TRUE(std::isnan(y[1]) && std::isnan(y[7]));
  EXPECT_EQ(y[0], 1.0);
}

TEST(Sine, IsExactToRoundOffUpToARightAngle)
{
  Random random(3);
  long double worst = 0.0;
  for (int k = 0; k < 100000; ++k) {
    const Real x = random.between(-1.5707963267948966, 1.5707963267948966);
    worst = std::max(worst, std::abs(sine(x) - std::sin(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 3e-16L);
  EXPECT_EQ(sine(0.0), 0.0);
}

TEST(Sine, IsTheSameInAPackAndAlone)
{
  const std::array<Real, 8> x{-1.5, -0.3, 0.0, 1e-9, 0.2, 0.5235987755982988, 1.0, 1.5};
  const auto y = lanes_of(sine(pack_of(x)));
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(y[lane], sine(x[lane]));
}

TEST(Pack, GathersWhatItsIndicesNameAndNothingElse)
{
  const std::vector<Real> numbers{10.0, 11.0, 20.0, 21.0, 30.0, 31.0};
  alignas(64) constexpr std::array<Real, pack_width> index{
      2, 0, 1, 2, 1, 1e9, 1e9, 1e9};  // the last three lanes are beyond
  const Pack first = Pack::gather(numbers.data(), 2, index.data(), 5),
             second = Pack::gather(numbers.data() + 1, 2, index.data(), 5);
  constexpr std::array<Real, pack_width> expected{30.0, 10.0, 20.0, 30.0, 20.0, -1.0, -1.0, -1.0};
  for (int k = 0; k < pack_width; ++k) {
    EXPECT_EQ(first[k], expected[k] < 0.0 ? 0.0 : expected[k]) << k;
    EXPECT_EQ(second[k], expected[k] < 0.0 ? 0.0 : expected[k] + 1.0) << k;
  }
}

}  // namespace pack_test
