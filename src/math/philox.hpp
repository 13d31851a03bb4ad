// Random numbers by counting: the number that belongs to a place follows from the place alone, so that it is the same
// in any order, on any thread and on any machine.
// Not for: numbers with a distribution (model/soils/gaussian_field, study).
#pragma once

#include "math/types.hpp"

#include <array>
#include <cstdint>

namespace terp {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// Philox4x32-10 (Salmon, Moraes, Dror & Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11, 2011): 128 bits
/// that look random, from a counter and a key.
constexpr PhiloxCounter philox(PhiloxCounter x, PhiloxKey key)
{
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t even = 0xD2511F53ULL * x[0], odd = 0xCD9E8D57ULL * x[2];
    x = {static_cast<std::uint32_t>(odd >> 32) ^ x[1] ^ key[0], static_cast<std::uint32_t>(odd),
        static_cast<std::uint32_t>(even >> 32) ^ x[3] ^ key[1], static_cast<std::uint32_t>(even)};
    key = {key[0] + 0x9E3779B9U, key[1] + 0xBB67AE85U};  // golden ratio, and root of 3 less 1
  }
  return x;
}

/// A number between 0 and 1, neither of them, from 52 bits.
constexpr Real philox_uniform(PhiloxCounter x, PhiloxKey key)
{
  const PhiloxCounter bits = philox(x, key);
  const std::uint64_t whole = (std::uint64_t{bits[0]} << 20) | (bits[1] >> 12);
  return (static_cast<Real>(whole) + 0.5) * 0x1.0p-52;
}

}  // namespace terp
