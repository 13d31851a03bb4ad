// What a kernel needs of a number where its text serves a pack too, and how wide a pack is. Not for: packs (pack.hpp).
#pragma once

#include "math/types.hpp"

#include <cmath>

namespace terp {

struct Pack;
struct Mask;

inline constexpr int pack_width = 8;

/// Smallest multiple of pack_width that is not below n.
constexpr Index round_up_to_pack(Index n) { return (n + pack_width - 1) / pack_width * pack_width; }

inline Real select(bool m, Real a, Real b) { return m ? a : b; }
inline Real min(Real a, Real b) { return a < b ? a : b; }
inline Real max(Real a, Real b) { return a > b ? a : b; }
inline Real abs(Real a) { return a < 0 ? -a : a; }
inline bool any_of(bool m) { return m; }
inline Real sqrt(Real a) { return std::sqrt(a); }
inline Real sum(Real a) { return a; }
inline Real fma(Real a, Real b, Real c)
{
#if defined(__FMA__)
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

}  // namespace terp
