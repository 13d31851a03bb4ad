// Logarithm, power and hyperbolic tangent against long double over all numbers, in packs and alone.
#include "math/functions.hpp"
#include "support/random.hpp"

namespace functions_test {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();
constexpr Real smallest = std::numeric_limits<Real>::denorm_min();
constexpr Real largest = std::numeric_limits<Real>::max();

/// |got - exact| in units in the last place of exact; of denormal numbers in their step.
long double ulp_between(Real got, long double exact)
{
  if (std::isnan(got)) return std::isnan(exact) ? 0.0L : HUGE_VALL;
  if (std::isinf(got)) return std::abs(exact) > largest ? 0.0L : HUGE_VALL;
  int exponent = -2000;
  if (exact != 0.0L) std::frexp(std::abs(exact), &exponent);
  return std::abs(got - exact) / std::ldexp(1.0L, std::max(exponent - 53, -1074));
}

/// A positive number of any size, denormal ones too: all exponents alike often.
Real any_size(Random& random)
{
  return std::ldexp(random.between(1.0, 2.0), static_cast<int>(random.between(-1074.0, 1024.0)));
}

/// One plus or minus down to the last bit.
Real near_one(Random& random)
{
  return 1.0 + std::ldexp(random.between(-1.0, 1.0), -static_cast<int>(random.between(1.0, 53.0)));
}

/// A base and an exponent whose power reaches from denormal to infinite.
std::pair<Real, Real> base_and_exponent(Random& random, int k)
{
  const Real base = k % 3 == 0 ? any_size(random) : k % 3 == 1 ? near_one(random) : random.between(0.5, 2.0);
  return {base, random.between(-750.0, 750.0) / (std::abs(logarithm(base)) + 1e-300)};
}

TEST(Logarithm, IsWithinItsErrorOfAllNumbers)
{
  Random random(1);
  long double worst = 0.0L;
  for (int k = 0; k < 300000; ++k) {
    const Real x = k % 3 == 0 ? any_size(random) : k % 3 == 1 ? near_one(random) : random.between(0.0, 3.0);
    worst = std::max(worst, ulp_between(logarithm(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 1.5L);
  for (const Real x : {smallest, 3.0 * smallest, 2.2250738585072014e-308, largest})
    EXPECT_LT(ulp_between(logarithm(x), std::log(static_cast<long double>(x))), 1.0L) << x;
}

TEST(Logarithm, OfTheEndsAndBeyond)
{
  EXPECT_EQ(logarithm(1.0), 0.0);
  EXPECT_EQ(logarithm(0.0), -infinity);
  EXPECT_EQ(logarithm(-0.0), -infinity);
  EXPECT_EQ(logarithm(infinity), infinity);
  for (const Real x : {-smallest, -1.0, -infinity, not_a_number}) EXPECT_TRUE(std::isnan(logarithm(x))) << x;
}

TEST(Power, IsWithinItsErrorFromDenormalToInfinite)
{
  Random random(2);
  long double worst = 0.0L;
  for (int k = 0; k < 300000; ++k) {
    const auto [x, y] = base_and_exponent(random, k);
    worst =
        std::max(worst, ulp_between(power(x, y), std::pow(static_cast<long double>(x), static_cast<long double>(y))));
  }
  EXPECT_LT(worst, 2.0L);
}

TEST(Power, OfTheEndsIsThatOfTheStandardLibrary)
{
  for (const Real x : {0.0, -0.0, smallest, 0.5, 1.0, 2.0, largest, infinity})
    for (const Real y : {0.0, -0.0, smallest, -smallest, 1.0, -1.0, 1e300, -1e300, infinity, -infinity})
      EXPECT_EQ(power(x, y), std::abs(std::pow(x, y))) << x << " to " << y;
}

TEST(Power, OfANegativeBaseAndOfWhatIsNoNumberIsNoNumber)
{
  for (const Real y : {-1.0, 0.0, 2.0, infinity, not_a_number}) {
    EXPECT_TRUE(std::isnan(power(-1.0, y))) << y;
    EXPECT_TRUE(std::isnan(power(-infinity, y))) << y;
    EXPECT_TRUE(std::isnan(power(not_a_number, y))) << y;
  }
  EXPECT_TRUE(std::isnan(power(1.0, not_a_number)));
  EXPECT_TRUE(std::isnan(power(0.0, not_a_number)));
}

TEST(HyperbolicTangent, IsWithinItsErrorOfAllNumbers)
{
  Random random(3);
  long double worst = 0.0L;
  for (int k = 0; k < 300000; ++k) {
    const Real x = k % 3 == 0 ? any_size(random) : k % 3 == 1 ? random.between(-25.0, 25.0) : random.between(-1.0, 1.0);
    worst = std::max(worst, ulp_between(hyperbolic_tangent(x), std::tanh(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 3.0L);
}

TEST(HyperbolicTangent, OfTheEnds)
{
  EXPECT_EQ(hyperbolic_tangent(0.0), 0.0);
  EXPECT_EQ(hyperbolic_tangent(smallest), smallest);
  EXPECT_EQ(hyperbolic_tangent(-smallest), -smallest);
  EXPECT_EQ(hyperbolic_tangent(largest), 1.0);
  EXPECT_EQ(hyperbolic_tangent(infinity), 1.0);
  EXPECT_EQ(hyperbolic_tangent(-infinity), -1.0);
  EXPECT_TRUE(std::isnan(hyperbolic_tangent(not_a_number)));
}

/// Calls f(x) for packs of eight and f(number) for each of them; the bits must agree.
template <class F>
void expect_same_in_a_pack(const std::array<Real, 8>& x, F&& f)
{
  alignas(64) std::array<Real, 8> in = x, out;
  f(Pack::load(in.data())).store(out.data());
  for (int k = 0; k < 8; ++k)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(out[k]), std::bit_cast<std::uint64_t>(f(x[k]))) << x[k];
}

TEST(Functions, AreTheSameInAPackAndAlone)
{
  Random random(4);
  for (int k = 0; k < 3000; ++k) {
    std::array<Real, 8> x;
    for (Real& value : x) value = any_size(random);
    if (k == 0) x = {0.0, smallest, 1.0, infinity, largest, 0.5, 2.0, 1e-310};
    const Real y = random.between(-9.0, 9.0);
    expect_same_in_a_pack(x, [](auto a) { return logarithm(a); });
    expect_same_in_a_pack(x, [](auto a) { return hyperbolic_tangent(a); });
    expect_same_in_a_pack(x, [y](auto a) { return power(a, decltype(a)(y)); });
  }
}

/// The sum of many results bit by bit. The numbers are those of a run on AVX-512; AVX2 gives the same.
TEST(Functions, GiveTheSameBitsOnEverySetWithFusedProducts)
{
#if defined(__FMA__)
  Random random(5);
  std::uint64_t bits = 0;
  for (int k = 0; k < 100000; ++k) {
    const auto [x, y] = base_and_exponent(random, k);
    for (const Real value : {logarithm(x), power(x, y), hyperbolic_tangent(y)})
      bits = bits * 1099511628211u + std::bit_cast<std::uint64_t>(value);
  }
  EXPECT_EQ(bits, 8686300813361678681u);
#else
  GTEST_SKIP() << "compiled without fused products";
#endif
}

}  // namespace functions_test
