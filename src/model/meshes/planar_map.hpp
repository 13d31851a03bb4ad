// A polygon cut by lines: places, lines that meet only at places, and the faces between them.
// Not for: meshing. geo_text.hpp hands the faces to gmsh.
#pragma once

#include "math/types.hpp"

#include <vector>

namespace terp {

/// From place `a` to place `b`.
struct CutLine {
  Index a, b;
  Index edge;  ///< of the polygon: from its corner `edge` to the next; -1: a followed line inside
};

/// Loops of lines, the face to their left: the outer loop first, then the holes. Line k is written k + 1, or -(k + 1)
/// if it runs from b to a.
using Face = std::vector<std::vector<Index>>;

struct PlanarMap {
  std::vector<Vec<2>> places;  ///< [m]; the corners of the polygon come first, exact to the bit
  std::vector<CutLine> lines;
  std::vector<Face> faces;
};

/// Cuts a polygon (counter-clockwise, no corner twice in a row) by the outlines to follow. What lies outside is
/// dropped. Followed places closer to another place or to an edge than `tolerance` [m] are moved onto it, so that no
/// sliver remains; the polygon itself is never moved. Throws MeshError if the polygon crosses or lies on itself.
PlanarMap cut_polygon(
    const std::vector<Vec<2>>& polygon, const std::vector<std::vector<Vec<2>>>& follow, Real tolerance);

/// A closed walk with one face to its left.
struct FaceRing {
  std::vector<Index> places;  ///< in order
  std::vector<Index> edges;   ///< edge k goes from places[k] to the next
};

/// Face 0 is everything outside; its rings run clockwise. The first ring of any other face is its outline,
/// counter-clockwise; the others are its holes, clockwise.
struct PlanarFaces {
  std::vector<std::vector<FaceRing>> rings;  ///< by face
  std::vector<Index> left, right;            ///< face on each side of each edge, looking from its first place
};

/// Faces between edges, each from place to place, that meet only at places.
PlanarFaces find_faces(const std::vector<Vec<2>>& places, const std::vector<std::array<Index, 2>>& edges);

}  // namespace terp
