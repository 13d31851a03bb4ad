// Strength that grows with the logarithm of the rate of plastic shearing, and the return to it (decision 0044).
//
//   S = S_0 (1 + mu log10(max(rate, rate_ref)/rate_ref)),   rate = d/dt,   d the step's part of Eq. (6)
//
// Not for: S_0, and where the yield surface lies. The law passes both in.
#pragma once

#include "math/functions.hpp"
#include "math/pack.hpp"

namespace terp {

/// What a stress at the strength S_0(d) times a factor leaves over: how far the trial stress lies outside, less 2 G d
/// [Pa], with its two slopes. It falls as d and the factor grow.
template <class R>
struct Excess {
  R value, by_strain, by_factor;
};

template <class P>
struct RateFactor {
  P per_tenfold;  ///< mu [-]
  P rate_ref;     ///< of Eq. (6) [1/s]

  bool acts() const { return any_of(per_tenfold > P(0.0)); }

  /// Of a step of length dt [s] with the strain d.
  template <class R>
  R factor(R d, Real dt) const
  {
    if (!acts()) return R(1.0);
    return R(1.0) + R(per_tenfold * (1.0 / ln_10)) * logarithm(max(d / R(rate_ref * dt), R(1.0)));
  }

  /// Solves excess(d, factor(d/dt)) = 0 for the strain d of a step of length dt [s], and returns the factor.
  /// d: in the answer for a factor of 1, which is not less; out the answer.
  /// The unknown is u = ln(d/(rate_ref dt)): the factor is linear in it, and 2 G d curves one way, so that Newton's
  /// steps come from above and do not overshoot. A step out of what encloses the root is halved instead. Lanes that
  /// have settled keep their answer, so that it does not depend on the other lanes.
  template <class R, class Function>
  R solve(const Function& excess, Real dt, R& d) const
  {
    const R slow(rate_ref * dt), gain(per_tenfold * (1.0 / ln_10));
    R low(0.0), high = logarithm(max(d / slow, R(1.0))), u = high;
    const auto is_fast = (high > R(0.0)) & (gain > R(0.0));
    auto open = is_fast;
    for (int k = 0; k < most_steps && any_of(open); ++k) {
      const R at = slow * exponential(u);
      const Excess<R> left = excess(at, R(1.0) + gain * u);
      const auto below = left.value > R(0.0);  // the root lies above
      low = select(below, u, low);
      high = select(below, high, u);
      const R newton = u - left.value / (left.by_strain * at + left.by_factor * gain);
      const R next = select((newton >= low) & (newton <= high), newton, (low + high) * R(0.5));
      const auto moves = open & (abs(next - u) > R(settled));
      u = select(open, next, u);
      open = moves;
    }
    d = select(is_fast, slow * exponential(u), d);
    return select(is_fast, R(1.0) + gain * u, R(1.0));
  }

  static constexpr Real ln_10 = 2.302585092994045684;
  static constexpr Real settled = 1e-8;  // the next step is of its square
  static constexpr int most_steps = 60;  // measured: at most 9 on planes and edges (tresca_softening_test.cpp)
};

}  // namespace terp
