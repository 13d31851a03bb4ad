#include "mesh/cell_geometry.hpp"

#include <algorithm>

namespace terp {
namespace {

using Corners = std::array<Vec<2>, 4>;

Vec<2> combine(const Corners& x, const std::array<Real, 4>& sign)
{
  Vec<2> sum{0.0, 0.0};
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < 2; ++d) sum[d] += 0.25 * sign[i] * x[i][d];
  return sum;
}

/// dN_i/dx_d at (xi, eta), shape [corner][d], and detJ.
Real physical_gradients(const CellGeometry<2>& cell, Vec<2> at, std::array<Vec<2>, 4>& gradient)
{
  const auto j = jacobian(cell, at[0], at[1]);
  const auto local = shape_derivatives(at[0], at[1]);
  const Real det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
  for (int i = 0; i < 4; ++i) {
    gradient[i][0] = (j[1][1] * local[i][0] - j[1][0] * local[i][1]) / det;
    gradient[i][1] = (j[0][0] * local[i][1] - j[0][1] * local[i][0]) / det;
  }
  return det;
}

/// Smallest height of a corner over a side that it does not lie on.
Real smallest_altitude(const Corners& x)
{
  Real smallest = std::numeric_limits<Real>::infinity();
  for (int side = 0; side < 4; ++side) {
    const Vec<2>&a = x[side], &b = x[(side + 1) % 4];
    const Real length = std::hypot(b[0] - a[0], b[1] - a[1]);
    for (int other : {(side + 2) % 4, (side + 3) % 4}) {
      const Real area = (b[0] - a[0]) * (x[other][1] - a[1]) - (b[1] - a[1]) * (x[other][0] - a[0]);
      smallest = std::min(smallest, area / length);
    }
  }
  return smallest;
}

}  // namespace

CellGeometry<2> make_cell_geometry(const Corners& corners)
{
  CellGeometry<2> cell;
  cell.axis_xi = combine(corners, {-1, 1, 1, -1});
  cell.axis_eta = combine(corners, {-1, -1, 1, 1});
  cell.twist = combine(corners, {1, -1, 1, -1});
  const Real size = std::hypot(cell.axis_xi[0], cell.axis_xi[1]) + std::hypot(cell.axis_eta[0], cell.axis_eta[1]);
  cell.affine = std::hypot(cell.twist[0], cell.twist[1]) <= 1e-13 * size;  // below: round-off of equal corners
  if (cell.affine) cell.twist = {0.0, 0.0};

  std::array<Vec<2>, 4> gradient;
  for (int g = 0; g < 4; ++g) {
    cell.gauss_volume[g] = physical_gradients(cell, gauss_place(g), gradient);  // Gauss weight 1
    cell.volume += cell.gauss_volume[g];
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) cell.gradient[i][d][g] = gradient[i][d];
  }
  physical_gradients(cell, {0.0, 0.0}, cell.centre_gradient);
  cell.altitude = smallest_altitude(corners);
  return cell;
}

}  // namespace terp
