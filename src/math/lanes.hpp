// Packs turned: from numbers that lie side by side to one lane for each of eight places, and back. For work that is the
// same in eight cells, and for sums over lanes four at a time. Not for: arithmetic (pack.hpp).
#pragma once

#include "math/pack.hpp"

#include <array>

namespace terp {

/// n equal values. Written out, not a loop: GCC would fill memory instead of registers.
template <std::size_t n, class T>
std::array<T, n> repeat(const T& value)
{
  return [&]<std::size_t... k>(std::index_sequence<k...>) { return std::array<T, n>{((void)k, value)...}; }
  (std::make_index_sequence<n>{});
}

/// n packs of zeros, shape [n] or [m][n].
template <std::size_t n>
std::array<Pack, n> zero_packs()
{
  return repeat<n>(Pack(0.0));
}
template <std::size_t m, std::size_t n>
std::array<std::array<Pack, n>, m> zero_packs()
{
  return repeat<m>(zero_packs<n>());
}

/// The numbers of packs, one after the other.
template <std::size_t n>
Real* numbers_of(std::array<Pack, n>& packs)
{
  return reinterpret_cast<Real*>(packs.data());
}
template <std::size_t n>
const Real* numbers_of(const std::array<Pack, n>& packs)
{
  return reinterpret_cast<const Real*>(packs.data());
}

#if defined(__AVX2__)
namespace detail {

/// Lanes 0 ... 3 or 4 ... 7 of a pack.
inline __m256d low_half(Pack a)
{
#if defined(__AVX512F__)
  return __m256d(__builtin_shufflevector(a.part[0], a.part[0], 0, 1, 2, 3));
#else
  return __m256d(a.part[0]);
#endif
}
inline __m256d high_half(Pack a)
{
#if defined(__AVX512F__)
  return __m256d(__builtin_shufflevector(a.part[0], a.part[0], 4, 5, 6, 7));
#else
  return __m256d(a.part[1]);
#endif
}
inline Pack join_halves(__m256d low, __m256d high)
{
  Pack a;
#if defined(__AVX512F__)
  a.part[0] = Reals(__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7));
#else
  a.part[0] = Reals(low);
  a.part[1] = Reals(high);
#endif
  return a;
}

struct FourRows {
  __m256d row[4];
};

/// Number k of row c becomes number c of row k.
inline FourRows transpose(__m256d a, __m256d b, __m256d c, __m256d d)
{
  const __m256d ab_even = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
  const __m256d cd_even = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
  return {{_mm256_permute2f128_pd(ab_even, cd_even, 0x20), _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20),
      _mm256_permute2f128_pd(ab_even, cd_even, 0x31), _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31)}};
}

}  // namespace detail
#endif

/// Lane c of pack k is number k of place(c); place(0 ... 7): const Real*, four numbers each.
template <class Place>
std::array<Pack, 4> to_lanes(Place&& place)
{
  std::array<Pack, 4> lanes;
#if defined(__AVX2__)
  const auto row = [&](int c) { return _mm256_loadu_pd(place(c)); };
  const auto low = detail::transpose(row(0), row(1), row(2), row(3)),
             high = detail::transpose(row(4), row(5), row(6), row(7));
  for (int k = 0; k < 4; ++k) lanes[k] = detail::join_halves(low.row[k], high.row[k]);
#else
  alignas(64) Real numbers[4][pack_width];
  for (int c = 0; c < pack_width; ++c)
    for (int k = 0; k < 4; ++k) numbers[k][c] = place(c)[k];
  for (int k = 0; k < 4; ++k) lanes[k] = Pack::load(numbers[k]);
#endif
  return lanes;
}

/// The other way: lane c of pack k becomes number k of place(c); place(0 ... 7): Real*, room for four numbers each.
template <class Place>
void from_lanes(const std::array<Pack, 4>& lanes, Place&& place)
{
#if defined(__AVX2__)
  using namespace detail;
  const auto low = transpose(low_half(lanes[0]), low_half(lanes[1]), low_half(lanes[2]), low_half(lanes[3]));
  const auto high = transpose(high_half(lanes[0]), high_half(lanes[1]), high_half(lanes[2]), high_half(lanes[3]));
  for (int c = 0; c < 4; ++c) {
    _mm256_storeu_pd(place(c), low.row[c]);
    _mm256_storeu_pd(place(4 + c), high.row[c]);
  }
#else
  for (int c = 0; c < pack_width; ++c)
    for (int k = 0; k < 4; ++k) place(c)[k] = lanes[k][c];
#endif
}

/// sum() of each of four packs, with the same bits: turned while they are added, which takes a third of the
/// instructions.
inline std::array<Real, 4> sum_each(const std::array<Pack, 4>& a)
{
  std::array<Real, 4> sums;
#if defined(__AVX2__)
  const auto halves = [](Pack b) {
    return _mm256_add_pd(detail::low_half(b), detail::high_half(b));
  };                                                // lane k + lane k + 4
  const auto quarters = [](__m256d b, __m256d c) {  // lane k + lane k + 2 of both
    return _mm256_add_pd(_mm256_permute2f128_pd(b, c, 0x20), _mm256_permute2f128_pd(b, c, 0x31));
  };
  _mm256_storeu_pd(
      sums.data(), _mm256_hadd_pd(quarters(halves(a[0]), halves(a[2])), quarters(halves(a[1]), halves(a[3]))));
#else
  for (int k = 0; k < 4; ++k) sums[k] = sum(a[k]);
#endif
  return sums;
}

}  // namespace terp
