// The part of a section that a case takes over: the dike, the soil that can slide with it, and room on all sides.
// Not for: mesh and bodies (section_layout.hpp).
#pragma once

#include "import/drawing/clean_regions.hpp"

#include <optional>

namespace terp {

/// What is left and right of, and below, is not taken over.
struct SectionPart {
  Vec<2> between{-1e9, 1e9};  ///< [m]
  Real base = -1e9;           ///< [m]
  std::string why = {};       ///< empty: all of it is taken over, or somebody chose the part
};

/// On each side three times the height of the dike and twice the thickness of the undrained soil, from the toe on;
/// below the undrained soil, and below a depth of the dike's height under the ground, half that height. The height is
/// that of the crest over the lowest ground, the toe where the ground is a tenth of the crest's height over the lowest
/// ground of its side. Level ground: all of it. crest: its place [m]; is_undrained: by region.
SectionPart part_that_matters(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations,
    Vec<2> crest, const std::vector<bool>& is_undrained);

/// The part of each outline; nothing left of one: its polygon is empty. Throws InputError if nothing is left of any.
std::vector<DrawnRegion> part_of(const std::vector<DrawnRegion>& drawn, const SectionPart& part);

/// What the part leaves out of the section, a sentence; empty: nothing.
std::string describe(const SectionPart& part, const std::vector<DrawnRegion>& drawn);

}  // namespace terp
