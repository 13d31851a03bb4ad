// How wide a pack is, for what holds numbers in packs and computes nothing with them. Not for: packs (pack.hpp).
#pragma once

#include "math/types.hpp"

namespace terp {

struct Pack;
struct Mask;

inline constexpr int pack_width = 8;

/// Smallest multiple of pack_width that is not below n.
constexpr Index round_up_to_pack(Index n) { return (n + pack_width - 1) / pack_width * pack_width; }

}  // namespace terp
