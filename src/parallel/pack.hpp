// A pack: eight numbers that one instruction works on, and the few functions that a law or kernel needs so that one
// text serves a pack and a single Real alike. Always eight wide, so that sums have the same order on every machine;
// where the machine's registers are shorter the compiler splits the pack.
// Not for: anything that knows what the numbers mean.
#pragma once

#include "base/types.hpp"

#include <bit>
#include <cmath>
#include <cstring>

#if defined(__AVX2__) || defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace terp {

inline constexpr int pack_width = 8;

/// Smallest multiple of pack_width that is not below n.
constexpr Index round_up_to_pack(Index n) { return (n + pack_width - 1) / pack_width * pack_width; }

/// Eight truth values; all bits of a lane are set where true.
struct Mask {
  using Lanes = long long __attribute__((vector_size(64), may_alias));
  Lanes lanes;
};

struct Pack {
  using Lanes = double __attribute__((vector_size(64), may_alias));
  Lanes lanes;

  Pack() = default;
  Pack(Lanes l) : lanes(l) {}
  Pack(Real a) : lanes(Lanes{a, a, a, a, a, a, a, a}) {}
  Real operator[](int i) const { return lanes[i]; }

  /// p: 64-byte aligned, pack_width numbers.
  static Pack load(const Real* p) { return *reinterpret_cast<const Lanes*>(p); }
  void store(Real* p) const { *reinterpret_cast<Lanes*>(p) = lanes; }

  Pack& operator+=(Pack b) { lanes += b.lanes; return *this; }
  Pack& operator-=(Pack b) { lanes -= b.lanes; return *this; }
  Pack& operator*=(Pack b) { lanes *= b.lanes; return *this; }
};

inline Pack operator+(Pack a, Pack b) { return a.lanes + b.lanes; }
inline Pack operator-(Pack a, Pack b) { return a.lanes - b.lanes; }
inline Pack operator*(Pack a, Pack b) { return a.lanes * b.lanes; }
inline Pack operator/(Pack a, Pack b) { return a.lanes / b.lanes; }
inline Pack operator-(Pack a) { return -a.lanes; }
inline Mask operator<(Pack a, Pack b) { return {a.lanes < b.lanes}; }
inline Mask operator>(Pack a, Pack b) { return {a.lanes > b.lanes}; }
inline Mask operator<=(Pack a, Pack b) { return {a.lanes <= b.lanes}; }
inline Mask operator>=(Pack a, Pack b) { return {a.lanes >= b.lanes}; }
inline Mask operator&(Mask a, Mask b) { return {a.lanes & b.lanes}; }
inline Mask operator|(Mask a, Mask b) { return {a.lanes | b.lanes}; }
inline Mask operator!(Mask a) { return {~a.lanes}; }

/// a where the mask is true, b elsewhere.
inline Pack select(Mask m, Pack a, Pack b) { return m.lanes ? a.lanes : b.lanes; }
inline Real select(bool m, Real a, Real b) { return m ? a : b; }
inline Pack min(Pack a, Pack b) { return a.lanes < b.lanes ? a.lanes : b.lanes; }
inline Pack max(Pack a, Pack b) { return a.lanes > b.lanes ? a.lanes : b.lanes; }
inline Real min(Real a, Real b) { return a < b ? a : b; }
inline Real max(Real a, Real b) { return a > b ? a : b; }
inline Real abs(Real a) { return a < 0 ? -a : a; }
inline Pack abs(Pack a) { return max(a, -a); }

/// Bit k is set where lane k is true.
inline unsigned to_bits(Mask m)
{
#if defined(__AVX512DQ__)
  return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m.lanes));
#else
  unsigned bits = 0;
  for (int k = 0; k < pack_width; ++k) bits |= (m.lanes[k] != 0 ? 1u : 0u) << k;
  return bits;
#endif
}
inline bool any_of(Mask m) { return to_bits(m) != 0; }
inline bool any_of(bool m) { return m; }

/// Lane numbers 0 ... 7.
inline Pack lane_numbers() { return Pack::Lanes{0, 1, 2, 3, 4, 5, 6, 7}; }

/// a b + c, rounded once where the machine has the instruction.
inline Pack fma(Pack a, Pack b, Pack c)
{
#if defined(__AVX512F__)
  return Pack::Lanes(_mm512_fmadd_pd(__m512d(a.lanes), __m512d(b.lanes), __m512d(c.lanes)));
#elif defined(__FMA__)
  Pack r;
  for (int k = 0; k < pack_width; ++k) r.lanes[k] = __builtin_fma(a.lanes[k], b.lanes[k], c.lanes[k]);
  return r;
#else
  return a * b + c;
#endif
}
inline Real fma(Real a, Real b, Real c)
{
#if defined(__FMA__)
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

inline Pack sqrt(Pack a)
{
#if defined(__AVX512F__)
  return Pack::Lanes(_mm512_maskz_sqrt_pd(0xff, __m512d(a.lanes)));
#else
  Pack r;
  for (int k = 0; k < pack_width; ++k) r.lanes[k] = std::sqrt(a.lanes[k]);
  return r;
#endif
}
inline Real sqrt(Real a) { return std::sqrt(a); }

/// Sum of the lanes, always as ((0+4)+(2+6)) + ((1+5)+(3+7)).
inline Real sum(Pack a)
{
  const Pack::Lanes& l = a.lanes;
  return ((l[0] + l[4]) + (l[2] + l[6])) + ((l[1] + l[5]) + (l[3] + l[7]));
}
inline Real sum(Real a) { return a; }

namespace detail {
/// 2^n for whole n held in the low bits of n + 1.5 2^52.
inline Pack power_of_two(Pack shifted)
{
  Mask::Lanes bits = reinterpret_cast<Mask::Lanes>(shifted.lanes);
  bits = (bits + 1023) << 52;
  return Pack::Lanes(reinterpret_cast<Pack::Lanes>(bits));
}
inline Real power_of_two(Real shifted) { return std::bit_cast<Real>((std::bit_cast<std::uint64_t>(shifted) + 1023) << 52); }
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
                                        1.0 / 40320.0,     1.0 / 5040.0,     1.0 / 720.0,     1.0 / 120.0,
                                        1.0 / 24.0,        1.0 / 6.0,        0.5,             1.0,
                                        1.0};
  for (const Real c : inverse_factorial) p = fma(p, r, R(c));
  return p * detail::power_of_two(shifted);
}

}  // namespace terp
