// Bilinear shape functions of the 4-node quadrilateral in local coordinates xi, eta in [-1, 1].
//
// Corners run counter-clockwise: 0 (-1,-1), 1 (1,-1), 2 (1,1), 3 (-1,1). Sides: 0 eta = -1 (corners 0-1), 1 xi = 1
// (1-2), 2 eta = 1 (2-3), 3 xi = -1 (3-0). Sub-cell and Gauss point g = (xi >= 0) + 2 (eta >= 0).
#pragma once

#include "base/types.hpp"

namespace terp {

inline constexpr std::array<Vec<2>, 4> corner_place{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};

/// Local coordinate of Gauss point g, +-1/sqrt(3).
inline constexpr Real gauss_abscissa = 0.57735026918962576451;
constexpr Vec<2> gauss_place(int g)
{
  return {g & 1 ? gauss_abscissa : -gauss_abscissa, g & 2 ? gauss_abscissa : -gauss_abscissa};
}

/// Values N_i at (xi, eta), shape [4]. R is Real or Pack.
template <class R>
std::array<R, 4> shape_functions(R xi, R eta)
{
  const R left = R(0.5) - R(0.5) * xi, right = R(0.5) + R(0.5) * xi;
  const R low = R(0.5) - R(0.5) * eta, high = R(0.5) + R(0.5) * eta;
  return {left * low, right * low, right * high, left * high};
}

/// Derivatives dN_i/dxi, dN_i/deta at (xi, eta), shape [4][2].
template <class R>
std::array<std::array<R, 2>, 4> shape_derivatives(R xi, R eta)
{
  const R left = R(0.25) - R(0.25) * xi, right = R(0.25) + R(0.25) * xi;
  const R low = R(0.25) - R(0.25) * eta, high = R(0.25) + R(0.25) * eta;
  return {{{-low, -left}, {low, -right}, {high, right}, {-high, left}}};
}

}  // namespace terp
