// Symmetric tensors of rank two, tension positive, tensorial shear. Components xx yy zz xy (yz zx).
// R is Real, or Pack for eight tensors at once.
#pragma once

#include "math/types.hpp"

namespace terp {

template <class R, int Dim>
struct SymTensor {
  std::array<R, n_sym<Dim>> c;

  R& operator[](int k) { return c[k]; }
  const R& operator[](int k) const { return c[k]; }
};

/// Number of the component in row d and column e.
constexpr int component_of(int d, int e) { return d == e ? d : d + e == 1 ? 3 : d + e == 3 ? 4 : 5; }

template <class R, int Dim>
R trace(const SymTensor<R, Dim>& a)
{
  return a[0] + a[1] + a[2];
}

template <class R, int Dim>
void add_isotropic(SymTensor<R, Dim>& a, R value)
{
  for (int k = 0; k < 3; ++k) a[k] = a[k] + value;
}

/// a : b; each shear component counts twice.
template <class R, int Dim>
R double_dot(const SymTensor<R, Dim>& a, const SymTensor<R, Dim>& b)
{
  R direct = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  R shear = a[3] * b[3];
  for (int k = 4; k < n_sym<Dim>; ++k) shear = shear + a[k] * b[k];
  return direct + (shear + shear);
}

/// sigma += K tr(d_eps) I + 2 G dev(d_eps): isotropic linear elasticity. P: Real, or R where points differ in
/// stiffness.
template <class R, int Dim, class P>
void add_elastic_stress(SymTensor<R, Dim>& sigma, const SymTensor<R, Dim>& d_eps, P bulk, P shear)
{
  const R volumetric = trace(d_eps);
  const R lame = volumetric * R(bulk - 2.0 / 3.0 * shear);
  const R twice_shear(2.0 * shear);
  for (int k = 0; k < 3; ++k) sigma[k] = sigma[k] + (lame + twice_shear * d_eps[k]);
  for (int k = 3; k < n_sym<Dim>; ++k) sigma[k] = sigma[k] + twice_shear * d_eps[k];
}

}  // namespace terp
