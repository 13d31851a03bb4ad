// Packs turned eight by eight, and numbers looked up lane by lane in a table of sixteen. Not for: arithmetic
// (pack.hpp), four numbers at a time (lanes.hpp).
#pragma once

#include "math/lanes.hpp"

#include <algorithm>
#include <bit>

namespace terp {

/// Lane c of pack k becomes lane k of pack c.
inline std::array<Pack, pack_width> turn(const std::array<Pack, pack_width>& a)
{
  std::array<Pack, pack_width> turned;
#if defined(__AVX512F__)
  // Pairs of rows first: columns of one parity side by side. Then the 128 bits of each pair, in two rounds.
  const auto even = [&](int k) {
    return __builtin_shufflevector(a[k].part[0], a[k + 1].part[0], 0, 8, 2, 10, 4, 12, 6, 14);
  };
  const auto odd = [&](int k) {
    return __builtin_shufflevector(a[k].part[0], a[k + 1].part[0], 1, 9, 3, 11, 5, 13, 7, 15);
  };
  const auto lanes_0_2 = [](auto b, auto c) { return __builtin_shufflevector(b, c, 0, 1, 4, 5, 8, 9, 12, 13); };
  const auto lanes_1_3 = [](auto b, auto c) { return __builtin_shufflevector(b, c, 2, 3, 6, 7, 10, 11, 14, 15); };
  const auto finish = [&](int c, auto low, auto high) {
    turned[c].part[0] = lanes_0_2(low, high);
    turned[c + 4].part[0] = lanes_1_3(low, high);
  };
  const auto even_0 = even(0), even_2 = even(2), even_4 = even(4), even_6 = even(6);
  const auto odd_0 = odd(0), odd_2 = odd(2), odd_4 = odd(4), odd_6 = odd(6);
  finish(0, lanes_0_2(even_0, even_2), lanes_0_2(even_4, even_6));
  finish(1, lanes_0_2(odd_0, odd_2), lanes_0_2(odd_4, odd_6));
  finish(2, lanes_1_3(even_0, even_2), lanes_1_3(even_4, even_6));
  finish(3, lanes_1_3(odd_0, odd_2), lanes_1_3(odd_4, odd_6));
#elif defined(__AVX2__)
  using namespace detail;
  const auto low = [&](int k) {
    return transpose(low_half(a[k]), low_half(a[k + 1]), low_half(a[k + 2]), low_half(a[k + 3]));
  };
  const auto high = [&](int k) {
    return transpose(high_half(a[k]), high_half(a[k + 1]), high_half(a[k + 2]), high_half(a[k + 3]));
  };
  const FourRows low_low = low(0), low_high = low(4), high_low = high(0), high_high = high(4);
  for (int c = 0; c < 4; ++c) {
    turned[c] = join_halves(low_low.row[c], low_high.row[c]);
    turned[4 + c] = join_halves(high_low.row[c], high_high.row[c]);
  }
#else
  for (int k = 0; k < pack_width; k += 2)
    for (int c = 0; c < pack_width; c += 2) {
      const detail::Reals one = a[k].part[c / 2], other = a[k + 1].part[c / 2];
      turned[c].part[k / 2] = __builtin_shufflevector(one, other, 0, 2);
      turned[c + 1].part[k / 2] = __builtin_shufflevector(one, other, 1, 3);
    }
#endif
  return turned;
}

/// sum() of each of eight packs, with the same bits, in the lane of its number.
inline Pack sum_eight(const std::array<Pack, pack_width>& a)
{
#if defined(__AVX512F__)
  const auto part = [&](int k) { return a[k].part[0]; };
  const auto halves = [](auto b, auto c) {  // lane k + lane k + 4 of both
    return __builtin_shufflevector(b, c, 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(b, c, 4, 5, 6, 7, 12, 13, 14, 15);
  };
  const auto quarters = [](auto b, auto c) {  // lane k + lane k + 2 of all four
    return __builtin_shufflevector(b, c, 0, 1, 4, 5, 8, 9, 12, 13) +
           __builtin_shufflevector(b, c, 2, 3, 6, 7, 10, 11, 14, 15);
  };
  const auto even = quarters(halves(part(0), part(2)), halves(part(4), part(6)));
  const auto odd = quarters(halves(part(1), part(3)), halves(part(5), part(7)));
  Pack sums;
  sums.part[0] = __builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14) +
                 __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15);
  return sums;
#else
  alignas(64) Real sums[pack_width];
  std::ranges::copy(sum_each({a[0], a[1], a[2], a[3]}), sums);
  std::ranges::copy(sum_each({a[4], a[5], a[6], a[7]}), sums + 4);
  return Pack::load(sums);
#endif
}

#if defined(__AVX2__) && !defined(__AVX512F__)
namespace detail {

/// True in those of the lanes 4 half ... 4 half + 3 that are below n.
inline __m256i lanes_below(int n, int half)
{
  static constexpr long long flags[2 * pack_width] = {-1, -1, -1, -1, -1, -1, -1, -1};
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(flags + pack_width - n + 4 * half));
}

}  // namespace detail
#endif

/// The numbers first ... first + n - 1 at any address, n at most pack_width; zero in the lanes beyond.
inline Pack load_some(const Real* first, int n)
{
#if defined(__AVX512F__)
  Pack a;
  a.part[0] = detail::Reals(_mm512_maskz_loadu_pd(static_cast<__mmask8>((1u << n) - 1u), first));
  return a;
#elif defined(__AVX2__)
  const auto half = [&](int k) { return _mm256_maskload_pd(first + 4 * k, detail::lanes_below(n, k)); };
  return detail::join_halves(half(0), half(1));
#else
  alignas(64) Real numbers[pack_width] = {};
  for (int k = 0; k < n; ++k) numbers[k] = first[k];
  return Pack::load(numbers);
#endif
}

/// Lanes 0 ... n - 1 to any address.
inline void store_some(Pack a, Real* first, int n)
{
#if defined(__AVX512F__)
  _mm512_mask_storeu_pd(first, static_cast<__mmask8>((1u << n) - 1u), __m512d(a.part[0]));
#elif defined(__AVX2__)
  _mm256_maskstore_pd(first, detail::lanes_below(n, 0), detail::low_half(a));
  _mm256_maskstore_pd(first + 4, detail::lanes_below(n, 1), detail::high_half(a));
#else
  for (int k = 0; k < n; k += 2) {  // not copy_n, which calls a function for a number of bytes that it does not know
    const detail::Reals pair = a.part[k / 2];
    first[k] = pair[0];
    if (k + 1 < n) first[k + 1] = pair[1];
  }
#endif
}

/// Added to whole numbers below 16, it makes places of a table of them.
inline constexpr Real place_base = 6755399441055744.0;  // 1.5 2^52: the number stands in the low bits

/// Number of the entry that a place names.
inline int entry_at(Real place) { return static_cast<int>(std::bit_cast<std::uint64_t>(place) & 15u); }

/// Whether look_up is one instruction.
#if defined(__AVX512F__)
inline constexpr bool looks_up_at_once = true;
#else
inline constexpr bool looks_up_at_once = false;
#endif

/// table[k] in each lane, k + place_base its place. table: 64-byte aligned, 16 numbers.
inline Pack look_up(const Real* table, Pack places)
{
#if defined(__AVX512F__)
  Pack found;
  found.part[0] = detail::Reals(
      _mm512_permutex2var_pd(_mm512_load_pd(table), __m512i(places.part[0]), _mm512_load_pd(table + pack_width)));
  return found;
#else
  alignas(64) Real found[pack_width];
  for (int lane = 0; lane < pack_width; ++lane) found[lane] = table[entry_at(places[lane])];
  return Pack::load(found);
#endif
}

}  // namespace terp
