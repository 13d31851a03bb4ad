// The isoparametric map of one cell, relative to its centre, and what follows from it: equal cells share one.
#pragma once

#include "mpm/mesh/element.hpp"

namespace terp {

template <class E>
struct CellGeometry {
  using Element = E;
  typename E::Map map;
  PerCorner<E, PerDirection<E, PerGauss<E>>> gradient;  ///< dN_i/dx_d at Gauss point g [1/m], shape [corner i][d][g]
  PerCorner<E, Vec<E::dim>> centre_gradient;            ///< dN_i/dx_d at the centre [1/m], shape [corner][d]
  PerGauss<E> gauss_volume;                             ///< w_g detJ(xi_g) [m^2]
  Real volume = 0.0;                                    ///< [m^2]
  Real altitude = 0.0;                                  ///< L_e: smallest height over a side [m], reading R19
};

/// From the corners [m], in the order of the element.
template <class Element>
CellGeometry<Element> make_cell_geometry(const PerCorner<Element, Vec<Element::dim>>& corners);

}  // namespace terp
