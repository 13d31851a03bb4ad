// The isoparametric map of one cell and what the kernels need of it, free of the cell's place: equal cells share it.
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

  Vec<2> axis_xi, axis_eta, twist;           ///< [m]
  bool affine = true;                        ///< parallelogram: twist is zero to round-off
  std::array<std::array<Vec<4>, 2>, 4> gradient;  ///< dN_i/dx_d at Gauss point g [1/m], shape [corner i][d][g]
  std::array<Vec<2>, 4> centre_gradient;     ///< dN_i/dx_d at the centre [1/m], shape [corner][d]
  Vec<4> gauss_volume;                       ///< w_g detJ(xi_g) [m^2]
  Real volume = 0.0;                         ///< [m^2]
  Real altitude = 0.0;                       ///< L_e: smallest height over a side [m], reading R19
};

/// Offset of the place (xi, eta) from the cell's centre [m].
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

/// Newton steps of the inverse map from the parallelogram's answer. Measured (tests/mesh/cell_geometry_test.cpp): round-off after six
/// in squares with corners moved by up to 30 % of the side, and with 25 % also a tenth of the side beyond. At 35 %, where a corner
/// may be almost straight, 1e-4 of the side after six, round-off after ten.
inline constexpr int inverse_map_steps = 6;

/// Improves local coordinates of a place, given as offset from the cell's centre [m], by Newton steps.
template <class R>
void improve_local_coordinates(const CellGeometry<2>& cell, R x, R y, int steps, R& xi, R& eta)
{
  for (int step = 0; step < steps; ++step) {
    const auto at = offset_from_centre(cell, xi, eta);
    const auto j = jacobian(cell, xi, eta);
    const R rx = x - at[0], ry = y - at[1];
    const R inverse_det = R(1.0) / (j[0][0] * j[1][1] - j[0][1] * j[1][0]);
    xi += (j[1][1] * rx - j[0][1] * ry) * inverse_det;
    eta += (j[0][0] * ry - j[1][0] * rx) * inverse_det;
  }
}

/// Local coordinates of a place given as offset from the cell's centre [m]; a pure function of the offset. Exact for
/// parallelograms, Newton from their solution otherwise. Places far outside a strongly twisted cell may have no answer.
template <class R>
std::array<R, 2> local_coordinates(const CellGeometry<2>& cell, R x, R y)
{
  const Real det_0 = cell.axis_xi[0] * cell.axis_eta[1] - cell.axis_xi[1] * cell.axis_eta[0];
  const Real i00 = cell.axis_eta[1] / det_0, i01 = -cell.axis_eta[0] / det_0;
  const Real i10 = -cell.axis_xi[1] / det_0, i11 = cell.axis_xi[0] / det_0;
  R xi = fma(R(i00), x, R(i01) * y), eta = fma(R(i10), x, R(i11) * y);
  if (!cell.affine) improve_local_coordinates(cell, x, y, inverse_map_steps, xi, eta);
  return {xi, eta};
}

/// Newton steps that take the local coordinates of a place to those of a place `distance` [m] away: an error e becomes about e^2 / 2, so
/// that 4e-4 takes two and 2e-2 three steps to round-off.
inline int newton_steps_for(const CellGeometry<2>& cell, Real distance)
{
  const Real part = distance / cell.altitude;  // about half the change of xi
  return part < 2e-4 ? 2 : part < 1e-2 ? 3 : inverse_map_steps;
}

/// Local coordinates of a place near one whose coordinates are known (near).
template <class R>
std::array<R, 2> local_coordinates_near(const CellGeometry<2>& cell, R x, R y, const std::array<R, 2>& near, int newton_steps)
{
  if (cell.affine) return local_coordinates(cell, x, y);
  std::array<R, 2> local = near;
  improve_local_coordinates(cell, x, y, newton_steps, local[0], local[1]);
  return local;
}

/// From the corners, counter-clockwise [m].
CellGeometry<2> make_cell_geometry(const std::array<Vec<2>, 4>& corners);

}  // namespace terp
