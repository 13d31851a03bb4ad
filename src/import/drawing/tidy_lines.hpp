// What stands in a drawing beside the section: outlines that are nearly closed, frames, water lines, walls, boundaries
// without ends. Not for: which regions the lines enclose (dxf_regions.hpp).
#pragma once

#include "import/drawing/dxf_file.hpp"

namespace terp {

/// Of the width of a section: a shorter piece that bounds nothing is a tick, or what is left of a crossing.
inline constexpr Real short_piece = 0.05;

struct TidyLines {
  std::vector<DxfLine> lines;
  std::vector<std::string> notes = {};   ///< what was changed, as sentences
  std::vector<std::string> doubts = {};  ///< what speaks against the drawing, the same
};

/// Whether the name of a layer says that it is water, and no ground.
bool is_of_water(const std::string& layer);

/// Closes outlines whose ends lie within `snap` [m], and boundaries that end at one x by a vertical. Leaves out open
/// water lines, lines that end within an outline, frames, tables, copies of outlines, and the ground lines of an
/// exported section. Throws InputError if the drawing holds several sections, or what may be a frame or soil.
TidyLines tidy_lines(const DxfDrawing& drawing, Real snap);

}  // namespace terp
