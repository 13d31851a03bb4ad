// A pack: eight numbers that one instruction works on, and the few functions that a law or kernel needs so that one
// text serves a pack and a single Real alike. Always eight wide, so that sums have the same order on every machine;
// where registers are shorter a pack is two or four of them.
// Not for: anything that knows what the numbers mean.
#pragma once

#include "math/number.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace terp {

namespace detail {

#if defined(__AVX512F__)
inline constexpr int register_width = 8;
#elif defined(__AVX2__)
inline constexpr int register_width = 4;
#else
inline constexpr int register_width = 2;
#endif
inline constexpr int n_registers = pack_width / register_width;

/// As many numbers, or truth values, as fit into one register. GCC would split a vector of eight by itself, but number
/// by number.
using Reals = double __attribute__((vector_size(8 * register_width), may_alias));
using Truths = long long __attribute__((vector_size(8 * register_width), may_alias));

/// Truth values as comparisons give them: one bit each where there are registers of bits.
using Flags =
#if defined(__AVX512F__)
    __mmask8;
#else
    Truths;
#endif

inline Flags less(Reals a, Reals b)
{
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(__m512d(a), __m512d(b), _CMP_LT_OQ);
#else
  return Truths(a < b);
#endif
}

inline Flags less_or_equal(Reals a, Reals b)
{
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(__m512d(a), __m512d(b), _CMP_LE_OQ);
#else
  return Truths(a <= b);
#endif
}

inline Reals broadcast(Real a)
{
#if defined(__AVX512F__)
  return Reals{a, a, a, a, a, a, a, a};
#elif defined(__AVX2__)
  return Reals{a, a, a, a};
#else
  return Reals{a, a};
#endif
}

/// a where m is true, b elsewhere. All bits of a truth value are equal.
inline Reals choose(Flags m, Reals a, Reals b)
{
#if defined(__AVX512F__)
  return Reals(_mm512_mask_blend_pd(m, __m512d(b), __m512d(a)));
#elif defined(__AVX2__)
  return Reals(_mm256_blendv_pd(__m256d(b), __m256d(a), __m256d(m)));
#elif defined(__SSE2__)
  return Reals(_mm_or_pd(_mm_and_pd(__m128d(m), __m128d(a)), _mm_andnot_pd(__m128d(m), __m128d(b))));
#else
  return m ? a : b;
#endif
}

/// Bit k is set where number k is true.
inline unsigned bits_of(Flags m)
{
#if defined(__AVX512F__)
  return m;
#elif defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_pd(__m256d(m)));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(__m128d(m)));
#else
  return (m[0] != 0 ? 1u : 0u) | (m[1] != 0 ? 2u : 0u);
#endif
}

inline Reals fused(Reals a, Reals b, Reals c)
{
#if defined(__AVX512F__)
  return Reals(_mm512_fmadd_pd(__m512d(a), __m512d(b), __m512d(c)));
#elif defined(__AVX2__) && defined(__FMA__)
  return Reals(_mm256_fmadd_pd(__m256d(a), __m256d(b), __m256d(c)));
#elif defined(__FMA__)
  return Reals{__builtin_fma(a[0], b[0], c[0]), __builtin_fma(a[1], b[1], c[1])};
#else
  return a * b + c;
#endif
}

inline Reals root(Reals a)
{
#if defined(__AVX512F__)
  return Reals(_mm512_maskz_sqrt_pd(0xff, __m512d(a)));
#elif defined(__AVX2__)
  return Reals(_mm256_sqrt_pd(__m256d(a)));
#elif defined(__SSE2__)
  return Reals(_mm_sqrt_pd(__m128d(a)));
#else
  return Reals{std::sqrt(a[0]), std::sqrt(a[1])};
#endif
}

/// a < b ? a : b in one instruction, which gives b as well where the two are equal or one is no number.
inline Reals smaller(Reals a, Reals b)
{
#if defined(__AVX512F__)
  return Reals(_mm512_maskz_min_pd(0xff, __m512d(a), __m512d(b)));
#elif defined(__AVX2__)
  return Reals(_mm256_min_pd(__m256d(a), __m256d(b)));
#elif defined(__SSE2__)
  return Reals(_mm_min_pd(__m128d(a), __m128d(b)));
#else
  return a < b ? a : b;
#endif
}

/// a > b ? a : b, in the same way.
inline Reals larger(Reals a, Reals b)
{
#if defined(__AVX512F__)
  return Reals(_mm512_maskz_max_pd(0xff, __m512d(a), __m512d(b)));
#elif defined(__AVX2__)
  return Reals(_mm256_max_pd(__m256d(a), __m256d(b)));
#elif defined(__SSE2__)
  return Reals(_mm_max_pd(__m128d(a), __m128d(b)));
#else
  return a > b ? a : b;
#endif
}

/// f(k) for each register k, as a Pack or Mask. Written out, not a loop: GCC keeps a pack in registers only if no
/// loop runs over its parts when it decides.
template <class Result, class F>
Result each_part(F&& f)
{
  Result r;
  [&]<int... k>(std::integer_sequence<int, k...>) { ((r.part[k] = f(k)), ...); }
  (std::make_integer_sequence<int, n_registers>{});
  return r;
}

}  // namespace detail

/// Eight truth values.
struct Mask {
  detail::Flags part[detail::n_registers];
};

/// Aligned as `load` wants its numbers, whatever the registers of this copy: the numbers of a pack may go to a law of
/// another copy.
struct alignas(64) Pack {
  detail::Reals part[detail::n_registers];

  Pack() = default;
  Pack(Real a) : Pack(detail::each_part<Pack>([&](int) { return detail::broadcast(a); })) {}
  Real operator[](int i) const { return part[i / detail::register_width][i % detail::register_width]; }

  /// p: 64-byte aligned, pack_width numbers.
  static Pack load(const Real* p)
  {
    return detail::each_part<Pack>(
        [&](int k) { return *reinterpret_cast<const detail::Reals*>(p + k * detail::register_width); });
  }
  /// from[stride * index[k]] in lane k < n, zero beyond. index: whole numbers not below 0, 64-byte aligned, shape
  /// [pack_width].
  static Pack gather(const Real* from, int stride, const Real* index, Index n)
  {
#if defined(__AVX512DQ__)
    const auto lanes = static_cast<__mmask8>(n < pack_width ? (1u << n) - 1u : 0xffu);
    const __m512i numbers = _mm512_mullo_epi64(_mm512_cvttpd_epi64(_mm512_load_pd(index)), _mm512_set1_epi64(stride));
    Pack a;
    a.part[0] = detail::Reals(_mm512_mask_i64gather_pd(_mm512_setzero_pd(), lanes, numbers, from, sizeof(Real)));
    return a;
#else
    alignas(64) Real numbers[pack_width] = {};
    for (Index k = 0; k < pack_width && k < n; ++k) numbers[k] = from[stride * static_cast<std::ptrdiff_t>(index[k])];
    return load(numbers);
#endif
  }
  void store(Real* p) const
  {
    [&]<int... k>(std::integer_sequence<int, k...>)
    {
      ((*reinterpret_cast<detail::Reals*>(p + k * detail::register_width) = part[k]), ...);
    }
    (std::make_integer_sequence<int, detail::n_registers>{});
  }

  Pack& operator+=(Pack b);
  Pack& operator-=(Pack b);
  Pack& operator*=(Pack b);
};

inline Pack operator+(Pack a, Pack b)
{
  return detail::each_part<Pack>([&](int k) { return a.part[k] + b.part[k]; });
}
inline Pack operator-(Pack a, Pack b)
{
  return detail::each_part<Pack>([&](int k) { return a.part[k] - b.part[k]; });
}
inline Pack operator*(Pack a, Pack b)
{
  return detail::each_part<Pack>([&](int k) { return a.part[k] * b.part[k]; });
}
inline Pack operator/(Pack a, Pack b)
{
  return detail::each_part<Pack>([&](int k) { return a.part[k] / b.part[k]; });
}
inline Pack operator-(Pack a)
{
  return detail::each_part<Pack>([&](int k) { return -a.part[k]; });
}
inline Pack& Pack::operator+=(Pack b) { return *this = *this + b; }
inline Pack& Pack::operator-=(Pack b) { return *this = *this - b; }
inline Pack& Pack::operator*=(Pack b) { return *this = *this * b; }
inline Mask operator<(Pack a, Pack b)
{
  return detail::each_part<Mask>([&](int k) { return detail::less(a.part[k], b.part[k]); });
}
inline Mask operator>(Pack a, Pack b)
{
  return detail::each_part<Mask>([&](int k) { return detail::less(b.part[k], a.part[k]); });
}
inline Mask operator<=(Pack a, Pack b)
{
  return detail::each_part<Mask>([&](int k) { return detail::less_or_equal(a.part[k], b.part[k]); });
}
inline Mask operator>=(Pack a, Pack b)
{
  return detail::each_part<Mask>([&](int k) { return detail::less_or_equal(b.part[k], a.part[k]); });
}
inline Mask operator&(Mask a, Mask b)
{
  return detail::each_part<Mask>([&](int k) { return detail::Flags(a.part[k] & b.part[k]); });
}
inline Mask operator|(Mask a, Mask b)
{
  return detail::each_part<Mask>([&](int k) { return detail::Flags(a.part[k] | b.part[k]); });
}
inline Mask operator!(Mask a)
{
  return detail::each_part<Mask>([&](int k) { return detail::Flags(~a.part[k]); });
}

/// a where the mask is true, b elsewhere.
inline Pack select(Mask m, Pack a, Pack b)
{
  return detail::each_part<Pack>([&](int k) { return detail::choose(m.part[k], a.part[k], b.part[k]); });
}
inline Pack min(Pack a, Pack b)
{
  return detail::each_part<Pack>([&](int k) { return detail::smaller(a.part[k], b.part[k]); });
}
inline Pack max(Pack a, Pack b)
{
  return detail::each_part<Pack>([&](int k) { return detail::larger(a.part[k], b.part[k]); });
}
inline Pack abs(Pack a) { return max(a, -a); }

/// Bit k is set where lane k is true.
inline unsigned to_bits(Mask m)
{
  unsigned bits = 0;
  for (int k = 0; k < detail::n_registers; ++k) bits |= detail::bits_of(m.part[k]) << (k * detail::register_width);
  return bits;
}
inline bool any_of(Mask m)
{
  detail::Flags any = m.part[0];
  for (int k = 1; k < detail::n_registers; ++k) any = detail::Flags(any | m.part[k]);
  return detail::bits_of(any) != 0;
}

/// Lane numbers 0 ... 7.
inline Pack lane_numbers()
{
  alignas(64) static constexpr Real numbers[pack_width] = {0, 1, 2, 3, 4, 5, 6, 7};
  return Pack::load(numbers);
}

/// a b + c, rounded once where the machine has the instruction.
inline Pack fma(Pack a, Pack b, Pack c)
{
  return detail::each_part<Pack>([&](int k) { return detail::fused(a.part[k], b.part[k], c.part[k]); });
}

inline Pack sqrt(Pack a)
{
  return detail::each_part<Pack>([&](int k) { return detail::root(a.part[k]); });
}

/// Sum of the lanes, always as ((0+4)+(2+6)) + ((1+5)+(3+7)).
inline Real sum(Pack a)
{
  for (int half = detail::n_registers / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) a.part[k] += a.part[k + half];
  detail::Reals l = a.part[0];
  for (int half = detail::register_width / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) l[k] += l[k + half];
  return l[0];
}

namespace detail {
/// 2^n for whole n held in the low bits of n + 1.5 2^52.
inline Pack power_of_two(Pack shifted)
{
  return each_part<Pack>([&](int k) { return Reals((Truths(shifted.part[k]) + 1023) << 52); });
}
inline Real power_of_two(Real shifted)
{
  return std::bit_cast<Real>((std::bit_cast<std::uint64_t>(shifted) + 1023) << 52);
}
}  // namespace detail

/// e^x for -700 <= x <= 700 (clamped outside) to within 1e-15 relative: Cody-Waite reduction and a Taylor polynomial of
/// degree 13 on |r| <= ln(2)/2, whose remainder is below 5e-18. NaN stays NaN.
template <class R>
R exponential(R x)
{
  constexpr Real magic = 6755399441055744.0;  // 1.5 2^52: adding it rounds to a whole number
  constexpr Real ln2_high = 6.93145751953125e-1, ln2_low = 1.42860682030941723212e-6;
  const R inside = select(x > R(700.0), R(700.0), select(x < R(-700.0), R(-700.0), x));
  const R shifted = fma(inside, R(1.4426950408889634074), R(magic));
  const R n = shifted - R(magic);
  const R r = fma(n, R(-ln2_low), fma(n, R(-ln2_high), inside));
  R p(1.0 / 6227020800.0);
  constexpr Real inverse_factorial[] = {1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0,
      1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0};
  for (const Real c : inverse_factorial) p = fma(p, r, R(c));
  return p * detail::power_of_two(shifted);
}

/// sin(x) for |x| <= pi/2 to within 3e-16: a Taylor polynomial of degree 21, whose remainder is below 2e-18.
template <class R>
R sine(R x)
{
  constexpr Real inverse_factorial[] = {-1.0 / 121645100408832000.0, 1.0 / 355687428096000.0, -1.0 / 1307674368000.0,
      1.0 / 6227020800.0, -1.0 / 39916800.0, 1.0 / 362880.0, -1.0 / 5040.0, 1.0 / 120.0, -1.0 / 6.0, 1.0};
  const R square = x * x;
  R p(1.0 / 51090942171709440000.0);
  for (const Real c : inverse_factorial) p = fma(p, square, R(c));
  return p * x;
}

}  // namespace terp
