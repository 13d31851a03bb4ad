// The clean regions of a section as pieces of one soil, cut along the phreatic line where the soil differs above and
// below it, and at the level of the inner toe where its faces would ravel. Not for: bodies and materials of them
// (case_folder.hpp).
#pragma once

#include "import/dstability/preload.hpp"
#include "import/dstability/section_layout.hpp"

#include <optional>

namespace terp {

struct SectionPiece {
  CleanRegion region;
  std::size_t soil;
  int zone;                      ///< 0: the soil is alike above and below; 1: below the phreatic line, 2: above
  std::optional<Real> pop = {};  ///< of SHANSEP soil [Pa]; none: its yield stress is on a grid
  std::string history = {};      ///< of its preload: pieces of one soil and history share a grid
  bool is_face = false;          ///< cohesionless soil above the inner toe: cohesion in its outer metre
};

/// What the pieces are made of; all outlive the call.
struct PieceSources {
  const StixSection &now, &first;
  const StixScenario& scenario;
  const SectionLayout& layout;
  const CleanSection& clean;
  const std::vector<Vec<2>>& phreatic;     ///< empty: there is no water
  const std::vector<std::size_t>& layers;  ///< of the stage, by drawn region
  std::optional<Real> toe = {};            ///< level above which soil of little cohesion is a face [m]; none: nowhere
  Real face_cohesion = 0.0;                ///< soil with less is of little cohesion [Pa]
};

struct SectionPieces {
  std::vector<SectionPiece> of_file, below_base;
  std::vector<std::string> geometry;  ///< what was moved, for the report
};

SectionPieces pieces_of(const PieceSources& from);

/// The largest vertical effective stress in all pieces of this soil above or below the water, at places a step apart
/// [Pa]. Only a straight line through a table of strength asks for it: of other soil zero.
Real largest_stress(
    const StixSection& section, const std::vector<SectionPiece>& pieces, const SectionPiece& piece, Real step);

}  // namespace terp
