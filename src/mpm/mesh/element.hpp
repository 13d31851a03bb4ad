// The element of a mesh, and arrays by its directions, corners and Gauss points. An element is a struct of constants
// and functions, like Quad4: numbers of corners, Gauss points and sides; shape functions; the map of a cell and its
// inverse; sub-cells. Kernels take it as an argument of their template, so that its numbers stand in its own file
// alone. They say `inline`, as GCC then puts them into their callers more readily.
#pragma once

#include "mpm/mesh/quad4.hpp"

namespace terp {

/// One number for each direction, corner or Gauss point of an element. R is Real, or Pack for eight at once.
template <class Element, class R = Real>
using PerDirection = std::array<R, Element::dim>;
template <class Element, class R = Real>
using PerCorner = std::array<R, Element::n_corners>;
template <class Element, class R = Real>
using PerGauss = std::array<R, Element::n_gauss>;

/// The element of a mesh in Dim dimensions: an entry for each Dim.
template <int Dim>
struct ElementOf;
template <>
struct ElementOf<2> {
  using Type = Quad4;
};

}  // namespace terp
