// Logarithm, power and hyperbolic tangent, one text for a pack and a single Real, over all numbers that there are.
// A law that needs them includes this file; exponential and sine are in pack.hpp.
//
// Every set with fused products gives the same bits, in a pack and alone (decision 0023). Each function selects between
// values and takes no branch. Errors are in units in the last place (ulp), measured against long double by
// tests/math/functions_test.cpp, with and without fused products.
//
// log x: x = 2^n m with m in [sqrt(1/2), sqrt(2)); log m = 2 atanh(s), s = (m - 1)/(m + 1), by its series in s^2.
// x^y: e^(y log x), with log x and its product with y as sums of two numbers: y log x reaches 745, so that one number
// would leave an error of some hundred ulp.
// tanh x: (e^2x - 1)/(e^2x + 1), from the series of e^r - 1, which keeps small numbers.
#pragma once

#include "math/pack.hpp"

#include <limits>

namespace terp {
namespace detail {

inline constexpr Real infinity = std::numeric_limits<Real>::infinity();
inline constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();
/// ln 2 to 3e-23; high has 20 bits, so that its product with an exponent is exact.
inline constexpr Real ln2_high = 6.93145751953125e-1, ln2_low = 1.42860682030941723212e-6;
inline constexpr Real magic = 1.5 * 4503599627370496.0;  // 1.5 2^52: adding it rounds to a whole number in the low bits

/// An unevaluated sum; low is at most half a unit in the last place of high.
template <class R>
struct TwoParts {
  R high, low;
};

/// high + low for |high| >= |low|, or high = 0.
template <class R>
TwoParts<R> fast_two_sum(R high, R low)
{
  const R sum = high + low;
  return {sum, low - (sum - high)};
}

/// a b as product and round-off. Without a fused product by halves of 26 bits (Dekker 1971); |a|, |b| below 1e290.
template <class R>
TwoParts<R> two_product(R a, R b)
{
  const R product = a * b;
#if defined(__FMA__)
  return {product, fma(a, b, -product)};
#else
  const auto high_half = [](R x) {
    const R large = R(134217729.0) * x;  // 2^27 + 1
    return large - (large - x);
  };
  const R a_high = high_half(a), a_low = a - a_high, b_high = high_half(b), b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
#endif
}

inline constexpr std::uint64_t mantissa_bits = (1ULL << 52) - 1, bits_of_one = 1023ULL << 52,
                               bits_of_two_52 = 1075ULL << 52;
inline constexpr Real two_52 = 4503599627370496.0;  // 2^52: its last bit counts ones

/// The bits of a positive number x that is not denormal: exponent n and mantissa m in [1, 2), x = 2^n m.
inline void split(Pack x, Pack& n, Pack& m)
{
  using Bits = unsigned long long __attribute__((vector_size(8 * register_width), may_alias));
  m = each_part<Pack>([&](int k) { return Reals((Bits(x.part[k]) & mantissa_bits) | bits_of_one); });
  n = each_part<Pack>([&](int k) { return Reals(Bits(x.part[k]) >> 52 | bits_of_two_52); }) - Pack(two_52 + 1023.0);
}
inline void split(Real x, Real& n, Real& m)
{
  const auto bits = std::bit_cast<std::uint64_t>(x);
  m = std::bit_cast<Real>((bits & mantissa_bits) | bits_of_one);
  n = std::bit_cast<Real>(bits >> 52 | bits_of_two_52) - (two_52 + 1023.0);
}

/// x = 2^n m, m in [sqrt(1/2), sqrt(2)), of a positive finite x; denormal ones too.
template <class R>
void split_finely(R x, R& n, R& m)
{
  const auto small = x < R(2.2250738585072014e-308);          // the least normal number
  split(select(small, x * R(18014398509481984.0), x), n, m);  // 2^54
  n = select(small, n - R(54.0), n);
  const auto upper = m > R(1.41421356237309504880);
  m = select(upper, m * R(0.5), m);
  n = select(upper, n + R(1.0), n);
}

/// sum over k of z^k / (2 k + first), k = 0 ... n - 1: the series of atanh(s)/s from s^(first - 1) on, z = s^2 <=
/// 0.0295.
template <int first, int n, class R>
R atanh_series(R z)
{
  R sum(1.0 / (2 * (n - 1) + first));
  for (int k = n - 2; k >= 0; --k) sum = fma(sum, z, R(1.0 / (2 * k + first)));
  return sum;
}

/// log x as a sum of two numbers, of a positive finite x: relative error below 2^-63.
template <class R>
TwoParts<R> log_in_two_parts(R x)
{
  R n, m;
  split_finely(x, n, m);
  const R f = m - R(1.0), divisor = m + R(1.0), divisor_low = m - (divisor - R(1.0));  // f and divisor_low are exact
  const R s = f / divisor;
  const auto back = two_product(s, divisor);
  const R s_low = (((f - back.high) - back.low) - s * divisor_low) / divisor;
  // 2 atanh(s) = 2 s + (2/3) s^3 + s^5 (2/5 + ...): the first two in two parts, the third is below 2e-4 of the first
  auto z = two_product(s, s);
  z.low = z.low + R(2.0) * s * s_low;
  auto cube = two_product(s, z.high);
  cube.low = cube.low + fma(s, z.low, s_low * z.high);
  constexpr Real two_thirds = 2.0 / 3.0, two_thirds_low = 3.7007434154171886e-17;  // 2/3 - two_thirds
  auto third = two_product(cube.high, R(two_thirds));
  third.low = third.low + fma(cube.high, R(two_thirds_low), cube.low * R(two_thirds));
  const R rest = R(2.0) * (cube.high * z.high) * atanh_series<5, 11>(z.high);
  auto log_m = fast_two_sum(R(2.0) * s, third.high);
  log_m = fast_two_sum(log_m.high, log_m.low + (third.low + (R(2.0) * s_low + rest)));
  // + n ln 2; n ln2_high is exact, and is zero or larger than log m
  const R n_high = n * R(ln2_high);
  const auto sum = fast_two_sum(n_high, log_m.high);
  const auto n_low = two_product(n, R(ln2_low));
  const auto next = fast_two_sum(sum.high, n_low.high);
  return fast_two_sum(next.high, next.low + (sum.low + (log_m.low + n_low.low)));
}

/// e^r - 1 for |r| <= ln(2)/2: the series up to r^14, whose rest is below 1e-18 of it.
template <class R>
R exp_minus_1(R r)
{
  constexpr Real inverse_factorial[] = {1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0,
      1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5};
  R p(1.0 / 87178291200.0);
  for (const Real c : inverse_factorial) p = fma(p, r, R(c));
  return fma(r * r, p, r);
}

/// x = k ln 2 + r, |r| <= ln(2)/2 and a little; k is a whole number, and in the low bits of shifted. |x| < 1100.
template <class R>
R reduce_exponent(R x, R& k, R& shifted)
{
  shifted = fma(x, R(1.4426950408889634074), R(magic));
  k = shifted - R(magic);
  return fma(k, R(-ln2_low), fma(k, R(-ln2_high), x));
}

}  // namespace detail

/// log x to 1.5 ulp (measured 1.3). -infinity of zero, not a number of a negative x.
template <class R>
R logarithm(R x)
{
  using namespace detail;
  R n, m;
  split_finely(x, n, m);
  const R f = m - R(1.0), s = f / (R(2.0) + f), z = s * s;
  // 2 atanh(s) = 2 s + s t, and 2 s = f - s f with f exact
  const R t = R(2.0) * z * atanh_series<3, 10>(z);
  const R log_m = fma(s, t - f, f);
  const R value = fma(n, R(ln2_high), fma(n, R(ln2_low), log_m));
  const R known = select(x < R(infinity), value, x);  // infinity, and what is not a number
  return select(x <= R(0.0), select(x < R(0.0), R(not_a_number), R(-infinity)), known);
}

/// x^y to 2 ulp (measured 1.5). Not a number of a negative x, also where y is a whole number, and wherever x or y is
/// not a number, also where the other would settle the result. Else as std::pow: x^0 = 1, 0^-1 = infinity.
template <class R>
R power(R x, R y)
{
  using namespace detail;
  const R base = select(x > R(0.0), select(x < R(infinity), x, R(1.0)), R(1.0));  // else settled below
  const auto log_x = log_in_two_parts(base);
  // Beyond +-1100 the result is infinite or zero whatever the number; y is bounded so that no product overflows.
  const R bounded = select(y > R(1e200), R(1e200), select(y < R(-1e200), R(-1e200), y));
  auto exponent = two_product(bounded, log_x.high);
  const R low = fma(bounded, log_x.low, exponent.low);
  const auto beyond = exponent.high > R(1100.0), below = exponent.high < R(-1100.0);
  const R high = select(beyond, R(1100.0), select(below, R(-1100.0), exponent.high));
  R k, shifted;
  const R r = reduce_exponent(high, k, shifted);
  const R bounded_low = select(beyond, R(0.0), select(below, R(0.0), low));
  const R e = exp_minus_1(r);
  const R value = R(1.0) + (e + fma(e, bounded_low, bounded_low));
  // 2^k in two factors, since k reaches +-1600
  const R half = fma(k, R(0.5), R(magic)), rest = (k - (half - R(magic))) + R(magic);
  R result = value * power_of_two(half) * power_of_two(rest);
  result = select(y > R(0.0), select(x <= R(0.0), R(0.0), select(x < R(infinity), result, R(infinity))),
      select(y < R(0.0), select(x <= R(0.0), R(infinity), select(x < R(infinity), result, R(0.0))), R(1.0)));
  result = select(x >= R(0.0), result, R(not_a_number));
  return select(y >= R(0.0), result, select(y < R(0.0), result, R(not_a_number)));
}

/// tanh x to 3 ulp (measured 2.5).
template <class R>
R hyperbolic_tangent(R x)
{
  using namespace detail;
  const R size = select(x < R(0.0), -x, x);
  const R twice = R(2.0) * select(size > R(22.0), R(22.0), size);  // 1 - tanh 22 is 2e-19
  R k, shifted;
  const R r = reduce_exponent(twice, k, shifted);
  const R scale = power_of_two(shifted);
  const R t = fma(scale, exp_minus_1(r), scale - R(1.0));  // e^(2 |x|) - 1
  const R value = t / (t + R(2.0));
  return select(x < R(0.0), -value, value);
}

}  // namespace terp
