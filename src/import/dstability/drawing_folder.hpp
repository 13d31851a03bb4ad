// A drawing as a case folder to fill in: its regions as bodies, soils from the table of defaults by their names.
// Not for: D-Stability files (case_folder.hpp).
#pragma once

#include "import/drawing/dxf_regions.hpp"
#include "import/dstability/case_text.hpp"
#include "import/dstability/soil_defaults.hpp"

#include <optional>

namespace terp {

struct DrawingFolderOptions {
  std::string path;                    ///< of the drawing, for comments
  Real cell = 0.0;                     ///< size of the cells [m]; 0: from the section
  std::optional<Vec<2>> between = {};  ///< x of the part that is taken over [m]; none: all
  std::optional<Real> base = {};       ///< level above which it is taken over [m]; none: all
  std::vector<SoilKind> kinds;
};

/// Throws InputError if an outline cannot be used.
CaseFolder drawing_folder_of(
    const DxfRegions& drawing, const std::vector<std::string>& notes, const DrawingFolderOptions& options);

/// Regions with areas, as a table.
std::string drawing_listing(const DxfRegions& drawing, const std::vector<std::string>& notes);

}  // namespace terp
