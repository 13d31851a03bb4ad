// Drawings as DXF text: lines, polylines, arcs, splines and blocks with their layers, read; polylines, written. Facts:
// docs/dxf.md. Not for: binary DXF, DWG; what the lines enclose (dxf_regions.hpp).
#pragma once

#include "math/types.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Sizes of a section whose unit is in no doubt [m].
inline constexpr Real narrowest_section = 1.0, widest_section = 5e3, highest_section = 300.0;

struct DxfLine {
  std::string layer;
  std::vector<Vec<2>> places;  ///< x to the right, y up [m]
  bool closed;
  std::string handle;  ///< of the entity in the file; may be empty
};

struct DxfDrawing {
  std::vector<DxfLine> lines;
  std::vector<std::string> notes = {};   ///< what was assumed or left out, as sentences
  std::vector<std::string> doubts = {};  ///< what speaks against it, the same
  std::vector<DxfLine> hatches = {};     ///< outlines of HATCH, closed
  bool layers_are_chosen = false;        ///< by the user: all of them are soil
  bool is_one_section = false;           ///< by the user: not to be looked for several
};

/// Length of a unit of the drawing in m, by its name in Terp (m, dm, cm, mm, ft, in); 0: there is no such unit.
Real dxf_unit(std::string_view name);

/// unit: of the drawing [m]; 0: that of the header, $INSUNITS, or m. layers: those to read; empty: all that the drawing
/// shows. Blocks are read where they are inserted, bent lines as chords. Throws InputError, one problem for each entity
/// that is not read, with its handle, up to ten; or for what is no DXF text.
DxfDrawing read_dxf_text(
    const std::string& path, std::string_view text, Real unit = 0.0, const std::vector<std::string>& layers = {});

/// The same of a file. Throws FileError if it cannot be read.
DxfDrawing read_dxf(const std::string& path, Real unit = 0.0, const std::vector<std::string>& layers = {});

/// Text of a drawing in m, in the oldest form that all programs read (release 12).
std::string dxf_text(const std::vector<DxfLine>& lines);

}  // namespace terp
