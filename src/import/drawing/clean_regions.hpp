// From the outlines of a drawn section, as they come, to regions that fill it without gap or overlap: places joined,
// layers inside others carved out, excavations cut, edges that are too short collapsed, outlines made simpler. Each
// region keeps its area. Method: one planar graph, whose boundaries are kept once (planar_graph.hpp,
// region_chains.hpp). Not for: soils and water; files.
#pragma once

#include "import/drawing/region_chains.hpp"

namespace terp {

struct DrawnRegion {
  std::string name;  ///< of the soil or layer; several regions may have one name
  Polygon polygon;   ///< [m]
};

/// A ditch or pit: all soil above the line, between its ends, is taken away.
struct DrawnExcavation {
  std::string name;
  std::vector<Vec<2>> places;  ///< [m]
};

struct CleaningOptions {
  Real snap = 1e-3;           ///< places and edges closer than this are one [m]
  Real shortest_edge = 0.05;  ///< shorter edges are collapsed, thinner gaps are filled [m]
  Real tolerance = 0.02;      ///< how far a boundary may lie from the one that was drawn [m]; 0: nothing is simplified
};

/// A connected piece of a drawn region.
struct CleanRegion {
  int drawn;                   ///< number of the drawn region
  Polygon polygon;             ///< counter-clockwise [m]
  std::vector<Polygon> holes;  ///< clockwise: filled by other regions, or empty [m]
};

/// The regions that chains part; nothing if lines touch each other, or if the chains of a region contradict each other.
std::optional<std::vector<CleanRegion>> regions_between(const ChainMap& map);

struct RegionChange {
  Real drawn_area;  ///< what its outline gives it, less the regions in it and what is dug away [m^2]
  Real area;        ///< of its clean pieces [m^2]
  int pieces;       ///< 0: nothing of it is left
};

/// A place that belongs to no region, or to more than one.
struct DrawingFault {
  Vec<2> x;                ///< a corner of it [m]
  Real area;               ///< [m^2]
  std::vector<int> drawn;  ///< regions that lie there; of a gap the one that was given it, or none
};

struct CleanSection {
  std::vector<CleanRegion> regions;    ///< a region that lies in another one comes after it
  std::vector<RegionChange> changes;   ///< by drawn region
  std::vector<DrawingFault> gaps;      ///< enclosed by regions; thin ones are filled
  std::vector<DrawingFault> overlaps;  ///< neither lies in the other: the smaller one got the place
  SnapCounts snaps;
  ChainChanges simplified;
  Index corners_drawn = 0, corners = 0;
  Real dug_area = 0.0;  ///< soil that excavations took away [m^2]
};

/// Throws InputError, one problem for each outline that cannot be used: too few corners, sides that cross, no area.
/// Its key is the name of the outline. Before outlines are clipped, which hides such faults.
void check_outlines(const std::vector<DrawnRegion>& drawn);

/// Checks outlines in the same way.
CleanSection clean_regions(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations,
    const CleaningOptions& options);

/// What was moved, filled and left, as sentences.
std::vector<std::string> describe(
    const CleanSection& section, const std::vector<DrawnRegion>& drawn, const CleaningOptions& options);

}  // namespace terp
