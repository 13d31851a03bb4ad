// The layers of soil that a drawing shows: closed polylines, or what its lines enclose.
// Not for: making them clean (clean_regions.hpp).
#pragma once

#include "import/drawing/clean_regions.hpp"
#include "import/drawing/dxf_file.hpp"

namespace terp {

struct DxfRegions {
  std::vector<DrawnRegion> regions;
  std::vector<std::string> notes = {};   ///< as sentences
  std::vector<std::string> doubts = {};  ///< the same
  Real snap = CleaningOptions{}.snap;    ///< places closer than this are one [m]
};

/// Of the lines as tidy_lines leaves them. If all are closed each is a region with the name of its layer in the
/// drawing. Otherwise regions are the faces between all lines, joined within `snap` [m]. Such a face has the name of
/// the smallest closed polyline around it; else that of the layer of its lines, if they have one; else "region 1",
/// "region 2", ... from the top. Hatches bound soil where no line does, and name what lines leave without a name.
/// Throws InputError if the lines enclose nothing.
DxfRegions regions_of(const DxfDrawing& drawing, Real snap);

}  // namespace terp
