// Lines of a drawing as a planar graph: places, edges that meet only at places, and the faces between them.
// Not for: which soil a face belongs to (clean_regions.hpp); cutting the domain of a mesh
// (model/meshes/planar_map.hpp), whose polygon must never move.
#pragma once

#include "model/meshes/planar_map.hpp"
#include "model/bodies/polygon.hpp"

#include <optional>
#include <string>
#include <vector>

namespace terp {

/// An edge takes up places beside it that are nearer than this share of the snap distance: 1/sqrt(2), rounded down.
inline constexpr Real edge_reach = 0.7;

struct DrawnLine {
  std::vector<Vec<2>> places;  ///< [m]
  bool closed;                 ///< an outline: an owner that passes an edge twice cancels
  int owner;
};

/// From place a to place b, both numbers of PlanarGraph::places.
struct GraphEdge {
  Index a, b;
  std::vector<int> owners;  ///< ascending, each once
};

/// What joining the lines took.
struct SnapCounts {
  Index merged = 0;     ///< places that became another one
  Index joined = 0;     ///< edges that were bent to a place beside them: T-junctions
  Index crossings = 0;  ///< places added where edges cross
  Real largest = 0.0;   ///< distance over which a place or an edge moved, at most [m]
};

struct PlanarGraph {
  std::vector<Vec<2>> places;  ///< [m]; at least the snap distance apart
  std::vector<GraphEdge> edges;
  std::vector<GraphEdge> loose = {};  ///< that bound no face, left out of the edges
  SnapCounts counts;
};

/// Merges places closer than `snap` [m], bends edges to places closer than 0.7 of that, and cuts edges where they
/// cross. No place moves: later ones become earlier ones. Edges without owners and loose ends are left out. Throws
/// InputError if the lines are so many and so near to each other that this comes to no end.
PlanarGraph join_lines(const std::vector<DrawnLine>& lines, Real snap);

/// Its faces; sides of an edge are those looking from a to b.
PlanarFaces find_faces(const PlanarGraph& graph);

/// The region of each face, by the owners of its edges 0 to the left and 1 to the right; nothing if they contradict
/// each other.
std::optional<std::vector<int>> regions_by_edges(const PlanarGraph& graph, const PlanarFaces& faces);

/// Corners of a ring [m].
Polygon corners_of(const PlanarGraph& graph, const FaceRing& ring);

/// Area of a face [m^2]; of face 0 it is less than zero.
Real area_of_face(const PlanarGraph& graph, const std::vector<FaceRing>& rings);

/// A place within an outline that runs counter-clockwise, beside the middle of its longest edge [m].
Vec<2> place_in(const Polygon& outline);

/// Distance of a place from the part of a polyline between two of its corners [m]. distance_to_line rounds otherwise,
/// and the corners that an import keeps depend on its last digit.
Real distance_to(const Polygon& line, std::size_t first, std::size_t last, Vec<2> x);

/// Whether two lines neither cross nor touch but at ends that they share.
bool are_apart(const std::vector<Vec<2>>& places, const GraphEdge& e, const GraphEdge& f);

/// True if no two lines cross or touch but at their ends.
bool lines_are_apart(const PlanarGraph& graph);

}  // namespace terp
