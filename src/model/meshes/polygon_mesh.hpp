// What a mesh is generated from: a domain polygon, a target size, and what the cells shall respect. Plain numbers and
// names.
#pragma once

#include "math/types.hpp"

#include <string>
#include <vector>

namespace terp {

/// A named part of the boundary: edge k of the polygon runs from corner k to corner k + 1.
struct NamedEdges {
  std::string side;
  std::vector<Index> edges;
};

/// Smaller cells near a line or in a box.
struct Refinement {
  std::vector<Vec<2>> line;              ///< two or more places [m]; empty: a box
  Vec<2> low{0.0, 0.0}, high{0.0, 0.0};  ///< corners of the box [m]
  Real cell = 0.0;                       ///< target cell size there [m]
  Real distance = 0.0;                   ///< from the line or box over which the size grows back [m]
};

struct PolygonMesh {
  std::vector<Vec<2>> polygon;    ///< corners of the domain, counter-clockwise [m]
  Real cell = 0.0;                ///< target cell size: root of the median cell area [m]
  std::vector<NamedEdges> edges;  ///< edges that nobody names get no name
  std::vector<Refinement> refine;
  std::vector<std::vector<Vec<2>>> follow;  ///< outlines that cell sides follow where they lie inside the domain [m]
  int variant = 0;  ///< 0: the best mesh; 1, 2, ...: different unstructured meshes of the same size
  Real turn = 0.0;  ///< 0: cells of any direction; else inside squares in this direction against x [deg], of one size
};

/// Area over the area of a cell, without the refinements.
Real estimate_cells(const PolygonMesh& mesh);

/// Cells that a refinement adds, at most.
Real estimate_more_cells(const PolygonMesh& mesh, const Refinement& refine);

}  // namespace terp
