// The return of soil whose strength follows the plastic strain of the step: any return to a surface that stays where it
// is, made implicit. Not for: the surface, and how its strength falls (the laws).
#pragma once

#include "math/pack.hpp"

namespace terp {

/// Solves d = d_e(strength at d) by regula falsi (Illinois) between 0, where the left side is below, and `high`, where
/// it is not. return_at(d, d_e): the stress for the strength at the strain d of the step, and in d_e the strain that
/// this return makes. Any answer is on the surface of the strength that belongs to it. softens: lanes whose strength
/// changes; the others take the return at 0. settled: of d. d: out. Lanes that have settled keep their answer, so that
/// it does not depend on the other lanes.
template <class R, class Truth, class Return>
auto return_softening(const Return& return_at, Truth softens, R high, R settled, R& d)
{
  constexpr int most_trials = 60;
  const R tiny(1e-30);          // keeps 0/0 from brackets that have closed
  R low(0.0), at_low, at_high;  // d_e less d; above 0 at `low`, below at `high`
  auto best = return_at(R(0.0), at_low);
  d = select(softens, R(0.0), at_low);
  auto open = softens & (at_low > settled);
  if (!any_of(open)) return best;
  return_at(high, at_high);
  at_high = at_high - high;
  auto was_below = R(0.0) > R(0.0), was_above = was_below;
  for (int k = 0; k < most_trials && any_of(open); ++k) {
    const R next = low + (high - low) * (at_low / (at_low - min(at_high, -tiny)));
    R d_e;
    const auto returned = return_at(next, d_e);
    best = select(open, returned, best);
    d = select(open, next, d);
    const R rest = d_e - next;
    const auto below = rest > R(0.0);  // the root lies above
    const auto above = rest <= R(0.0);
    at_high = select(below, select(was_below, at_high * R(0.5), at_high), rest);
    at_low = select(below, rest, select(was_above, at_low * R(0.5), at_low));
    was_below = below, was_above = above;
    low = select(below, next, low);
    high = select(below, high, next);
    open = open & (abs(rest) > settled);
  }
  return best;
}

}  // namespace terp
