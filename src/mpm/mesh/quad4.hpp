// The element of the background mesh in two dimensions: the 4-node quadrilateral with bilinear shape functions. Kernels
// take it as an argument of their template; element.hpp says what they take from it.
//
// Local coordinates xi, eta in [-1, 1]. Corners run counter-clockwise: 0 (-1,-1), 1 (1,-1), 2 (1,1), 3 (-1,1).
// Side s runs from corner s to the next: 0 eta = -1, 1 xi = 1, 2 eta = 1, 3 xi = -1. Each quarter of the square is the
// sub-cell of one Gauss point: g = (xi >= 0) + 2 (eta >= 0).
#pragma once

#include "math/types.hpp"
#include "math/number.hpp"

#include <cmath>

namespace terp {

struct Quad4 {
  static constexpr int dim = 2;
  static constexpr int n_corners = 4;
  static constexpr int n_gauss = 4;  ///< Gauss points, and sub-cells
  static constexpr int n_sides = 4;

  /// One number for each direction, corner or Gauss point. R is Real or Pack.
  template <class R>
  using Local = std::array<R, dim>;
  template <class R>
  using PerCorner = std::array<R, n_corners>;
  template <class R>
  using PerGauss = std::array<R, n_gauss>;

  static constexpr PerCorner<Local<Real>> corner_place{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};

  /// Where a side lies: local coordinate `direction` has the value `place`.
  struct Side {
    std::array<int, 2> corners;
    int direction;
    Real place;
  };
  static constexpr std::array<Side, n_sides> sides{
      {{{0, 1}, 1, -1.0}, {{1, 2}, 0, 1.0}, {{2, 3}, 1, 1.0}, {{3, 0}, 0, -1.0}}};

  /// Number of the side at the end of direction d where the local coordinate is -1 or 1.
  static constexpr int side_at(int d, bool high) { return d == 0 ? (high ? 1 : 3) : (high ? 2 : 0); }

  /// Local coordinate of Gauss points, +-1/sqrt(3); their weight is 1.
  static constexpr Real gauss_abscissa = 0.57735026918962576451;
  static constexpr Local<Real> gauss_place(int g)
  {
    return {g & 1 ? gauss_abscissa : -gauss_abscissa, g & 2 ? gauss_abscissa : -gauss_abscissa};
  }

  /// Values N_i.
  template <class R>
  static PerCorner<R> shape_functions(const Local<R>& at)
  {
    const auto [xi, eta] = at;
    const R left = R(0.5) - R(0.5) * xi, right = R(0.5) + R(0.5) * xi;
    const R low = R(0.5) - R(0.5) * eta, high = R(0.5) + R(0.5) * eta;
    return {left * low, right * low, right * high, left * high};
  }

  /// Derivatives dN_i/dxi, dN_i/deta, shape [corner][local direction].
  template <class R>
  static PerCorner<Local<R>> shape_derivatives(const Local<R>& at)
  {
    const auto [xi, eta] = at;
    const R left = R(0.25) - R(0.25) * xi, right = R(0.25) + R(0.25) * xi;
    const R low = R(0.25) - R(0.25) * eta, high = R(0.25) + R(0.25) * eta;
    return {{{-low, -left}, {low, -right}, {high, right}, {-high, left}}};
  }

  /// For each direction whether local coordinates lie in the upper half of the cell. Those on the line between two
  /// sub-cells belong to the right and upper one, although round-off may leave them below it (reading R7).
  template <class R>
  static auto upper_halves(const Local<R>& at)
  {
    constexpr Real tie = 1e-9;
    return std::array{at[0] >= R(-tie), at[1] >= R(-tie)};
  }

  /// Of a value for each Gauss point that of the sub-cell in which each of eight points lies.
  template <class P = Pack, class M>
  static P at_sub_cell(const PerGauss<Real>& value, const Local<M>& upper)
  {
    return select(upper[1], select(upper[0], P(value[3]), P(value[2])), select(upper[0], P(value[1]), P(value[0])));
  }

  /// A value in the sub-cell where its point lies, zero in the others. M: bool, or Mask where R is Pack.
  template <class R, class M>
  static PerGauss<R> in_sub_cell(R value, const Local<M>& upper)
  {
    const R zero(0.0), low = select(upper[1], zero, value), high = select(upper[1], value, zero);
    return {select(upper[0], zero, low), select(upper[0], low, zero), select(upper[0], zero, high),
        select(upper[0], high, zero)};
  }

  /// The isoparametric map of a cell, relative to its centre: x - centre = axis_xi xi + axis_eta eta + twist xi eta.
  struct Map {
    Vec<2> axis_xi, axis_eta, twist;  ///< [m]
    bool affine = true;               ///< parallelogram: twist is zero to round-off
  };

  /// From the corners [m].
  static Map make_map(const PerCorner<Vec<2>>& corners);

  /// Smallest height of a corner over a side that it does not lie on [m].
  static Real smallest_altitude(const PerCorner<Vec<2>>& corners);

  /// Offset of a position from the cell's centre [m].
  template <class R>
  static std::array<R, 2> offset_from_centre(const Map& map, const Local<R>& at)
  {
    std::array<R, 2> x;
    for (int d = 0; d < dim; ++d) {
      x[d] = fma(R(map.axis_xi[d]), at[0], R(map.axis_eta[d]) * at[1]);
      x[d] = fma(R(map.twist[d]), at[0] * at[1], x[d]);
    }
    return x;
  }

  /// Jacobian dx_d/dxi, dx_d/deta, shape [d][local direction].
  template <class R>
  static std::array<Local<R>, 2> jacobian(const Map& map, const Local<R>& at)
  {
    std::array<Local<R>, 2> j;
    for (int d = 0; d < dim; ++d)
      j[d] = {fma(R(map.twist[d]), at[1], R(map.axis_xi[d])), fma(R(map.twist[d]), at[0], R(map.axis_eta[d]))};
    return j;
  }

  template <class R>
  static R determinant(const std::array<Local<R>, 2>& j)
  {
    return j[0][0] * j[1][1] - j[0][1] * j[1][0];
  }

  /// The determinant times the physical derivatives of a function with these local ones.
  template <class R>
  static std::array<R, 2> scaled_gradient(const std::array<Local<R>, 2>& j, const Local<R>& local)
  {
    return {j[1][1] * local[0] - j[1][0] * local[1], j[0][0] * local[1] - j[0][1] * local[0]};
  }

  /// Improves local coordinates of a position, given as offset from the cell's centre [m], by one Newton step.
  template <class R>
  static void improve_local_coordinates(const Map& map, const std::array<R, 2>& x, Local<R>& at)
  {
    const auto there = offset_from_centre(map, at);
    const auto j = jacobian(map, at);
    const R rx = x[0] - there[0], ry = x[1] - there[1];
    const R inverse_det = R(1.0) / determinant(j);
    at[0] += (j[1][1] * rx - j[0][1] * ry) * inverse_det;
    at[1] += (j[0][0] * ry - j[1][0] * rx) * inverse_det;
  }

  /// Local coordinates of a position given as offset p from the cell's centre [m]; a pure function of the offset. The
  /// map p = a xi + b eta + t xi eta gives cross(p - a xi, b + t xi) = 0, quadratic in xi, and the same for eta with a
  /// and b exchanged. The root with detJ > 0 is taken; both discriminants are detJ^2 there. Unlike Newton's method it
  /// also converges beside a corner that is almost straight. There its round-off is 3e-13 of the side, and one Newton
  /// step leaves 2e-16. Not a number where there is no root. Far outside a twisted cell the result may not map back to
  /// the position (locate.cpp).
  template <class R>
  static Local<R> local_coordinates(const Map& map, const std::array<R, 2>& offset)
  {
    const auto [x, y] = offset;
    const auto cross = [](Vec<2> u, Vec<2> w) { return u[0] * w[1] - u[1] * w[0]; };
    const auto cross_place = [&, x = x, y = y](Vec<2> w) { return x * R(w[1]) - y * R(w[0]); };
    const Vec<2>&a = map.axis_xi, &b = map.axis_eta, &t = map.twist;
    const Real det_0 = cross(a, b);
    if (map.affine) {
      const Real i00 = b[1] / det_0, i01 = -b[0] / det_0;
      const Real i10 = -a[1] / det_0, i11 = a[0] / det_0;
      return {fma(R(i00), x, R(i01) * y), fma(R(i10), x, R(i11) * y)};
    }
    const R p_a = cross_place(a), p_b = cross_place(b), p_t = cross_place(t);
    const R with_xi = R(det_0) - p_t, with_eta = R(det_0) + p_t;
    Local<R> at{R(2.0) * p_b / (with_xi + sqrt(with_xi * with_xi + R(4.0 * cross(a, t)) * p_b)),
        R(-2.0) * p_a / (with_eta + sqrt(with_eta * with_eta + R(4.0 * cross(b, t)) * p_a))};
    improve_local_coordinates(map, offset, at);
    return at;
  }
};

}  // namespace terp
