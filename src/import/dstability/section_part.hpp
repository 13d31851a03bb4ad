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
  Vec<2> toes{};              ///< elevation, left and right; of level ground none [m]
  std::string why = {};       ///< empty: all of it is taken over, or somebody chose the part
};

/// On each side three times the height of the dike and twice the thickness of the undrained soil, from the toe on;
/// below the undrained soil, and below a depth of the dike's height under the ground, half that height. The height is
/// that of the crest over the lowest ground, the toe where the ground is a tenth of the crest's height over the lowest
/// ground of its side. Level ground: all of it. crest: its place [m]; is_undrained: by region.
SectionPart part_that_matters(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations,
    Vec<2> crest, const std::vector<bool>& is_undrained);

/// Level of the inner toe [m]: of the ground `named`, at the toe that the file names, or else at the toe of the part on
/// the side without the river, "left" or "right"; at least that of the land; in whole millimetres. None: the ground is
/// level.
std::optional<Real> inner_toe(const SectionPart& part, const std::string& river, Real named, Real land);

/// The part of each outline; nothing left of one: its polygon is empty. Throws InputError if nothing is left of any.
std::vector<DrawnRegion> part_of(const std::vector<DrawnRegion>& drawn, const SectionPart& part);

/// What the part leaves out of the section, a sentence; empty: nothing.
std::string describe(const SectionPart& part, const std::vector<DrawnRegion>& drawn);

}  // namespace terp
