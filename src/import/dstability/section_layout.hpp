// The background mesh and the bodies of an imported section: cell size, limits, order, soil below an uneven base.
// Not for: soils (soil_text.hpp), water (water_text.hpp).
#pragma once

#include "import/drawing/clean_regions.hpp"
#include "import/dstability/case_text.hpp"

#include <optional>

namespace terp {

struct SectionLayout {
  Vec<2> low{}, high{};          ///< corners of the box about the soil [m]
  Vec<2> crest{};                ///< of the dike; of level ground its highest place [m]
  Real top = 0.0;                ///< of the ground [m]
  Real left = 0.0, right = 0.0;  ///< elevation of the ground at both ends [m]
  Real height = 0.0;             ///< of the dike: crest over the higher end; of level ground half its thickness [m]
  Real cell = 0.0;               ///< size of the cells [m]
};

enum class LandEnd { left, right, lower };

/// What is known of a section before it is laid out.
struct LayoutWishes {
  Real cell = 0.0;  ///< [m]; 0: a tenth of the height, a round number, or what a laptop solves in some minutes
  LandEnd land = LandEnd::lower;     ///< the end that the height is over
  std::optional<Vec<2>> crest = {};  ///< the dike has its crest between these x [m]; none: where the ground is highest
                                     ///< over the lowest ground on both of its sides
};

/// Throws InputError if the cells asked for are more than four million.
SectionLayout layout_of(
    const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations, const LayoutWishes& wishes);

/// Throws InputError if the cells that the user asks for [m] are larger than half of the height and a quarter of the
/// soil; 0: none are asked for.
void check_cell(const SectionLayout& layout, Real asked_for);

/// Limits of the soil [m].
BoundingBox box_around(const std::vector<DrawnRegion>& drawn);

/// The ground from left to right [m], excavations cut: two places at each corner, close to its left and its right.
/// more: x of further places.
std::vector<Vec<2>> ground_line(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations,
    const std::optional<Vec<2>>& more = {});

/// Places in a region on a grid [m]; at least one.
std::vector<Vec<2>> places_in(const CleanRegion& region, Real step);

/// Tolerances that fit the cells.
CleaningOptions cleaning_for(Real cell);

/// [mesh]: whole cells from limit to limit, two cells of air above the ground.
CaseTableText mesh_table(const SectionLayout& layout);

/// [boundary], [forces], [method], [initial], [output].
std::vector<CaseTableText> common_tables(const SectionLayout& layout);

/// [time]: what counts as rest. end: `until` of a run of one stage; empty: stages have their own.
CaseTableText time_table(const std::string& end);

/// What lies on one side of a line that cuts a region.
struct CutRegion {
  CleanRegion region;
  bool above = false;
};

/// The region cut along a line over x, level beyond its ends. Pieces thinner than `thin` [m] on average stay with the
/// other side; their area is added to `left_there` [m^2].
std::vector<CutRegion> cut_along(
    const CleanRegion& region, const std::vector<Vec<2>>& line, Real thin, Real& left_there);

/// Outlines in the order in which later ones lie on top; a hole that other bodies fill is left out.
struct BodyOrder {
  std::vector<CaseBodyText> bodies;
  std::vector<CleanRegion> regions;  ///< of the same bodies
};
void put_on_top(BodyOrder& order);

/// What lies between the lower limit of the section and a base that is not level, in pieces where the base meets the
/// limit or the soil has a gap. Each has the number of the drawn region that is above most of it, and no holes.
std::vector<CleanRegion> base_fill(const SectionLayout& layout, const std::vector<CleanRegion>& regions);

}  // namespace terp
