// Principal values of a symmetric tensor, and the tensor rebuilt from new ones with the old directions.
#pragma once

#include "math/tensor.hpp"
#include "math/pack.hpp"

namespace terp {

/// Principal values of a plane tensor: the in-plane pair a >= b, and zz, which may be the largest, middle or smallest.
template <class R>
struct PlanePrincipal {
  R a, b, zz;
  R cos_2, sin_2;  ///< of twice the angle from x to the direction of a; (1, 0) where a = b
};

template <class R>
PlanePrincipal<R> principal_values(const SymTensor<R, 2>& t)
{
  const R mean = (t[0] + t[1]) * R(0.5);
  const R half = (t[0] - t[1]) * R(0.5);
  const R radius = sqrt(fma(half, half, t[3] * t[3]));
  const auto round = radius <= R(0.0);
  const R inverse = R(1.0) / select(round, R(1.0), radius);
  return {mean + radius, mean - radius, t[2], select(round, R(1.0), half * inverse), t[3] * inverse};
}

template <class R>
SymTensor<R, 2> from_principal_values(const PlanePrincipal<R>& p)
{
  const R mean = (p.a + p.b) * R(0.5);
  const R radius = (p.a - p.b) * R(0.5);
  return {{fma(radius, p.cos_2, mean), mean - radius * p.cos_2, p.zz, radius * p.sin_2}};
}

/// Principal values from large to small.
template <class R>
struct Sorted {
  R major, middle, minor;
};

template <class Truth, class R>
Sorted<R> select(Truth m, const Sorted<R>& a, const Sorted<R>& b)
{
  return {select(m, a.major, b.major), select(m, a.middle, b.middle), select(m, a.minor, b.minor)};
}

template <class R>
Sorted<R> sort_principal_values(const PlanePrincipal<R>& p)
{
  return {max(p.a, p.zz), max(p.b, min(p.a, p.zz)), min(p.b, p.zz)};
}

/// Puts sorted values back to where the trial values stood: each takes its rank's place.
template <class R>
void assign_by_rank(const Sorted<R>& values, PlanePrincipal<R>& p)
{
  const auto zz_is_major = p.zz > p.a;
  const auto zz_is_minor = p.zz < p.b;
  p.a = select(zz_is_major, values.middle, values.major);
  p.b = select(zz_is_minor, values.middle, values.minor);
  p.zz = select(zz_is_major, values.major, select(zz_is_minor, values.minor, values.middle));
}

}  // namespace terp
