// Several sections in one drawing, beside or above each other: which there are, and the part that a window shows.
// Not for: lines that bound no soil (tidy_lines.hpp).
#pragma once

#include "import/drawing/dxf_file.hpp"
#include "mpm/mesh/box_grid.hpp"

namespace terp {

/// Keeps the lines that lie in a window [m], and notes which were left out. Throws InputError if none is left.
void keep_window(DxfDrawing& drawing, const BoundingBox& window);

/// Two of these open lines run from one x to another at different heights: tops of layers.
bool has_boundaries(const std::vector<DxfLine>& lines, Real snap);

struct SectionSearch {
  std::vector<bool> is_apart = {};  ///< by line: of a table or legend beside the section
  std::string doubt = {};           ///< a sentence, where two sections may lie above each other
};

/// Throws InputError, with their places, if lines of soil are several sections.
SectionSearch look_for_sections(const std::vector<DxfLine>& lines, Real snap);

}  // namespace terp
