// The water of a stage as a case has it: lines where they give the pressures of the file, else a grid of them.
// Not for: the pressures themselves (section.hpp).
#pragma once

#include "import/dstability/case_text.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/section_layout.hpp"

namespace terp {

/// The keys of a water, and how near they come to the pressures of the file.
struct WaterText {
  std::vector<CaseLine> lines;  ///< empty: the stage has no water
  std::string grid_file, grid;  ///< name and contents of a table that they name; empty: none
  Real deviation = 0.0;         ///< largest difference from the file's pressure in the soil [Pa]
  bool on_grid = false;
  std::vector<Vec<2>> phreatic;  ///< from left to right [m]; empty: none
};

/// name: of the grid file, without its ending. with_lines: the water of the start has reference lines, so that this one
/// must give its own.
WaterText water_text(const StixSection& section, const SectionLayout& layout, const std::string& name, bool with_lines);

/// The same of a stage without water in a case that has some in another stage.
WaterText water_below(const SectionLayout& layout);

}  // namespace terp
