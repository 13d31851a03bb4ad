// The background mesh: nodes, cells, neighbours and named sides. Never changes during a run.
// Not for: reading mesh files or for anything that moves.
#pragma once

#include "mpm/mesh/box_grid.hpp"
#include "mpm/mesh/cell_geometry.hpp"

#include <memory>
#include <string>
#include <vector>

namespace terp {

inline constexpr Index outside = -1;

/// One side of one cell.
struct CellSide {
  Index cell;
  int side;  ///< 0 ... 3, see quad4.hpp
};

/// A part of the boundary that the case file can name.
struct NamedSide {
  std::string name;
  std::vector<CellSide> edges = {};
  bool is_inside = false;  ///< it lies between two cells, so that it bounds nothing
};

/// Cells that the case file can name, e.g. a soil layer of a mesh file.
struct NamedRegion {
  std::string name;
  std::vector<Index> cells;  ///< ascending
};

/// A cell around a node, and which of its corners the node is.
struct CellCorner {
  std::uint32_t cell : 30;  // together the size of one Index: a mesh is mostly such tables
  std::uint32_t corner : 2;
};

template <int Dim>
struct Mesh {
  using Element = typename ElementOf<Dim>::Type;

  std::vector<Vec<Dim>> nodes;                               ///< [m], shape [n_nodes]
  std::vector<std::array<Index, Element::n_corners>> cells;  ///< corners, counter-clockwise, shape [n_cells]
  std::vector<std::array<Index, Element::n_sides>>
      neighbours;  ///< cell across each side, or `outside`, shape [n_cells]
  std::vector<NamedSide> sides;
  std::vector<NamedRegion> regions;               ///< empty for the built-in meshes
  std::vector<Vec<Dim>> centres;                  ///< mean of the corners [m], shape [n_cells]
  std::vector<CellGeometry<Element>> geometries;  ///< distinct shapes; equal cells share one
  std::vector<Index> geometry_of_cell;            ///< shape [n_cells]
  std::vector<Index> first_cell_of_node;          ///< into cells_of_node, shape [n_nodes + 1]
  std::vector<CellCorner> cells_of_node;          ///< in order of cell number
  Real smallest_altitude = 0.0;                   ///< [m]
  Index cell_of_smallest_altitude = 0;
  BoxGrid cell_grid;                       ///< of the cells' boxes, for positions without a first guess
  std::vector<std::int64_t> node_numbers;  ///< of the mesh file, shape [n_nodes]; empty for the built-in meshes
  std::vector<std::int64_t> cell_numbers;  ///< of the mesh file, shape [n_cells]; empty for the built-in meshes

  Index n_nodes() const { return static_cast<Index>(nodes.size()); }
  Index n_cells() const { return static_cast<Index>(cells.size()); }
  const CellGeometry<Element>& geometry(Index cell) const { return geometries[geometry_of_cell[cell]]; }
  std::array<Vec<Dim>, Element::n_corners> corners(Index cell) const
  {
    std::array<Vec<Dim>, Element::n_corners> x;
    for (int i = 0; i < Element::n_corners; ++i) x[i] = nodes[cells[cell][i]];
    return x;
  }
};

/// A mesh that several models hold at once; nobody changes it any more.
using SharedMesh = std::shared_ptr<const Mesh<2>>;

/// Fills everything that follows from nodes and cells: neighbours, centres, geometries, cells of nodes, grid of cells.
void connect(Mesh<2>& mesh);

/// Cells between (n[0] + 1) x (n[1] + 1) nodes that run along x first; n: cells per direction. Sides "left", "right",
/// "bottom", "top".
Mesh<2> make_grid(std::vector<Vec<2>> nodes, std::array<Index, 2> n);

/// Regular rectangle with sides "left", "right", "bottom", "top". n: cells per direction. Cells run along x first.
Mesh<2> make_rectangle(Vec<2> origin, Vec<2> size, std::array<Index, 2> n);

}  // namespace terp
