// Numbers that look random and are the same on every machine.
#pragma once

#include "support/test.hpp"
#include "math/types.hpp"

namespace terp::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2654435769u + 88172645463325252u) {}

  /// Uniform in [low, high).
  Real between(Real low, Real high) { return low + (high - low) * static_cast<Real>(next() >> 11) * 0x1.0p-53; }
  /// Uniform in 0 ... n-1.
  Index below(Index n) { return static_cast<Index>(next() % static_cast<std::uint64_t>(n)); }

 private:
  std::uint64_t next()  // xorshift64*, Vigna 2016
  {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return state_ * 2685821657736338717u;
  }
  std::uint64_t state_;
};

}  // namespace terp::test
