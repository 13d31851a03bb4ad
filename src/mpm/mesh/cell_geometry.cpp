#include "mpm/mesh/cell_geometry.hpp"

namespace terp {
namespace {

/// dN_i/dx_d at local coordinates, shape [corner][d], and detJ.
template <class Element>
Real physical_gradients(
    const typename Element::Map& map, Vec<Element::dim> at, PerCorner<Element, Vec<Element::dim>>& gradient)
{
  const auto j = Element::jacobian(map, at);
  const auto local = Element::shape_derivatives(at);
  const Real det = Element::determinant(j);
  for (int i = 0; i < Element::n_corners; ++i) {
    gradient[i] = Element::scaled_gradient(j, local[i]);
    for (Real& component : gradient[i]) component /= det;
  }
  return det;
}

}  // namespace

template <class Element>
CellGeometry<Element> make_cell_geometry(const PerCorner<Element, Vec<Element::dim>>& corners)
{
  CellGeometry<Element> cell;
  cell.map = Element::make_map(corners);
  PerCorner<Element, Vec<Element::dim>> gradient;
  for (int g = 0; g < Element::n_gauss; ++g) {
    cell.gauss_volume[g] = physical_gradients<Element>(cell.map, Element::gauss_place(g), gradient);  // Gauss weight 1
    cell.volume += cell.gauss_volume[g];
    for (int i = 0; i < Element::n_corners; ++i)
      for (int d = 0; d < Element::dim; ++d) cell.gradient[i][d][g] = gradient[i][d];
  }
  physical_gradients<Element>(cell.map, {}, cell.centre_gradient);
  cell.altitude = Element::smallest_altitude(corners);
  return cell;
}

template CellGeometry<Quad4> make_cell_geometry<Quad4>(const PerCorner<Quad4, Vec<2>>& corners);

}  // namespace terp
