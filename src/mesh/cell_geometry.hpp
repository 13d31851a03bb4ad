// The isoparametric map of one cell, relative to its centre: equal cells share one.
#pragma once

#include "mesh/shape_functions.hpp"
#include "parallel/pack.hpp"

namespace terp {

template <int Dim>
struct CellGeometry;

/// x - centre = axis_xi xi + axis_eta eta + twist xi eta.
template <>
struct CellGeometry<2> {
  static constexpr int n_gauss = 4;

  Vec<2> axis_xi, axis_eta, twist;                ///< [m]
  bool affine = true;                             ///< parallelogram: twist is zero to round-off
  std::array<std::array<Vec<4>, 2>, 4> gradient;  ///< dN_i/dx_d at Gauss point g [1/m], shape [corner i][d][g]
  std::array<Vec<2>, 4> centre_gradient;          ///< dN_i/dx_d at the centre [1/m], shape [corner][d]
  Vec<4> gauss_volume;                            ///< w_g detJ(xi_g) [m^2]
  Real volume = 0.0;                              ///< [m^2]
  Real altitude = 0.0;                            ///< L_e: smallest height over a side [m], reading R19
};

/// Offset of the position (xi, eta) from the cell's centre [m].
template <class R>
std::array<R, 2> offset_from_centre(const CellGeometry<2>& cell, R xi, R eta)
{
  std::array<R, 2> x;
  for (int d = 0; d < 2; ++d) {
    x[d] = fma(R(cell.axis_xi[d]), xi, R(cell.axis_eta[d]) * eta);
    x[d] = fma(R(cell.twist[d]), xi * eta, x[d]);
  }
  return x;
}

/// Jacobian dx_d/dxi, dx_d/deta, shape [d][2].
template <class R>
std::array<std::array<R, 2>, 2> jacobian(const CellGeometry<2>& cell, R xi, R eta)
{
  std::array<std::array<R, 2>, 2> j;
  for (int d = 0; d < 2; ++d)
    j[d] = {fma(R(cell.twist[d]), eta, R(cell.axis_xi[d])), fma(R(cell.twist[d]), xi, R(cell.axis_eta[d]))};
  return j;
}

/// Improves local coordinates of a position, given as offset from the cell's centre [m], by one Newton step.
template <class R>
void improve_local_coordinates(const CellGeometry<2>& cell, R x, R y, R& xi, R& eta)
{
  const auto at = offset_from_centre(cell, xi, eta);
  const auto j = jacobian(cell, xi, eta);
  const R rx = x - at[0], ry = y - at[1];
  const R inverse_det = R(1.0) / (j[0][0] * j[1][1] - j[0][1] * j[1][0]);
  xi += (j[1][1] * rx - j[0][1] * ry) * inverse_det;
  eta += (j[0][0] * ry - j[1][0] * rx) * inverse_det;
}

/// Local coordinates of a position given as offset p from the cell's centre [m]; a pure function of the offset. The map
/// p = a xi + b eta + t xi eta gives cross(p - a xi, b + t xi) = 0, quadratic in xi, and the same for eta with a and b
/// exchanged. The root with detJ > 0 is taken; both discriminants are detJ^2 there. Unlike Newton's method it also
/// converges beside a corner that is almost straight. There its round-off is 3e-13 of the side, and one Newton step
/// leaves 2e-16. Not a number where there is no root. Far outside a twisted cell the result may not map back to the
/// position (locate.cpp).
template <class R>
std::array<R, 2> local_coordinates(const CellGeometry<2>& cell, R x, R y)
{
  const auto cross = [](Vec<2> u, Vec<2> w) { return u[0] * w[1] - u[1] * w[0]; };
  const auto cross_place = [&](Vec<2> w) { return x * R(w[1]) - y * R(w[0]); };
  const Vec<2>&a = cell.axis_xi, &b = cell.axis_eta, &t = cell.twist;
  const Real det_0 = cross(a, b);
  if (cell.affine) {
    const Real i00 = b[1] / det_0, i01 = -b[0] / det_0;
    const Real i10 = -a[1] / det_0, i11 = a[0] / det_0;
    return {fma(R(i00), x, R(i01) * y), fma(R(i10), x, R(i11) * y)};
  }
  const R p_a = cross_place(a), p_b = cross_place(b), p_t = cross_place(t);
  const R with_xi = R(det_0) - p_t, with_eta = R(det_0) + p_t;
  R xi = R(2.0) * p_b / (with_xi + sqrt(with_xi * with_xi + R(4.0 * cross(a, t)) * p_b));
  R eta = R(-2.0) * p_a / (with_eta + sqrt(with_eta * with_eta + R(4.0 * cross(b, t)) * p_a));
  improve_local_coordinates(cell, x, y, xi, eta);
  return {xi, eta};
}

/// From the corners, counter-clockwise [m].
CellGeometry<2> make_cell_geometry(const std::array<Vec<2>, 4>& corners);

}  // namespace terp
