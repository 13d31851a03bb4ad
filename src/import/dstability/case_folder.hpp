// A stage of a D-Stability file as a case folder: case.toml, the tables that it names, and a report of what was read,
// assumed, moved and left out. docs/dstability.md, "The case folder".
// Not for: writing it; drawings (drawing_folder.hpp).
#pragma once

#include "import/dstability/case_text.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/soil_defaults.hpp"
#include "import/dstability/trigger.hpp"

#include <optional>

namespace terp {

struct FolderOptions {
  std::size_t scenario = 0, stage = 0;  ///< numbers from 0
  Real cell = 0.0;                      ///< size of the cells [m]; 0: from the section
  /// What is taken over of the section: between two x, and above a level [m]; none: section_part.hpp chooses.
  std::optional<Vec<2>> between = {};
  std::optional<Real> base = {};
  StixBasis basis = StixBasis::deterministic;
  std::vector<SoilKind> kinds;  ///< soil defaults
  bool has_films = true;        ///< at the top of aquifers (film.hpp)
  Real face_cohesion = 2e3;     ///< of soil with less, above the inner toe, in its outer metre [Pa]; 0: none
  bool is_held = false;         ///< the soil is held while the river rises: for a section that cannot stand
  FolderTrigger trigger = {};
  bool has_study = false;          ///< a study file beside the case
  std::optional<Real> river = {};  ///< level of the river [m]; none: that of the file
};

/// Throws InputError if the stage has no layer, or something in it cannot be taken over.
CaseFolder case_folder_of(const StixProject& project, const FolderOptions& options);

}  // namespace terp
