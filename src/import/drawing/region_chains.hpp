// Boundaries between regions as chains of lines, each kept once: what is done to a chain is done to both its regions,
// so no gap and no overlap can arise. Chains are made simpler and moved so that regions have the areas asked for.
// Not for: which region a face belongs to (clean_regions.hpp).
#pragma once

#include "import/drawing/planar_graph.hpp"

namespace terp {

/// A boundary from one junction to the next, or a closed one that meets no other (first place = last place).
struct Chain {
  std::vector<Index> places;
  int left, right;  ///< regions on its sides; -1: nothing is there
};

struct ChainMap {
  std::vector<Vec<2>> places;  ///< [m]; some belong to no chain
  std::vector<char>
      limits;  ///< by place: on the left limit of the drawing 1, on the right one 2, on the lower one 4; sums
  std::vector<char> junction;  ///< by place: ends chains, or is the corner of two limits
  std::vector<Chain> chains;
};

/// Boundaries between faces of different regions. region: by face; -1: none. Lines along the left, right and lower
/// limit keep only the corners that they need, and all places within `snap` [m] of a limit lie on it.
ChainMap find_chains(const PlanarGraph& graph, const PlanarFaces& faces, const std::vector<int>& region, Real snap);

struct ChainLimits {
  Real shortest_edge;  ///< shorter edges are collapsed where the boundaries stay apart [m]
  Real tolerance;      ///< how far a boundary may lie from the one that was drawn; short edges: their length [m]
  Real grid;           ///< new corners are at multiples of this [m]
};

struct ChainChanges {
  Index removed = 0;     ///< corners
  Index merged = 0;      ///< junctions that became another one
  Real largest = 0.0;    ///< distance between drawn and kept boundary, at most [m]
  Real area_move = 0.0;  ///< distance over which a corner moved to give the areas, at most [m]
};

/// Joins junctions closer than the shortest edge, and takes out corners. Each step keeps the area on both sides of the
/// chain, but for the rounding of corners to the grid and for joined junctions (Kronenfeld et al. 2020, "Simplification
/// of polylines by segment collapse: minimizing areal displacement while preserving area").
void simplify(ChainMap& map, const ChainLimits& limits, ChainChanges& changes);

/// Area of each region [m^2].
std::vector<Real> region_areas(const ChainMap& map, std::size_t n_regions);

/// Moves one corner of each chain, at most by `farthest` [m], so that the regions have these areas [m^2].
void balance_areas(ChainMap& map, const std::vector<Real>& areas, Real farthest, ChainChanges& changes);

/// The chains as a graph; an edge from a to b has its region to the left and the one to the right as owners 0 and 1.
PlanarGraph graph_of(const ChainMap& map);

}  // namespace terp
