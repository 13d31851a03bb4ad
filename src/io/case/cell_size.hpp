// A case on cells of another size: what to change in [mesh], whatever its kind.
#pragma once

#include "io/case/case_file.hpp"

#include <string>
#include <vector>

namespace terp {

/// Changes KEY=VALUE, as --set takes them, that give the cells of a case the size `cell` [m]. A rectangle keeps the
/// shape of its cells, of which `cell` is the width; a polygon the shares of its refinements; a graded or mapped grid
/// its grading, and `cell` is the root of the mean area of its cells. Throws CaseError where no such mesh can be made.
std::vector<std::string> changes_to_cell_size(const CaseFile& file, Real cell);

/// The sizes of --cells [m], the largest first. Throws CaseError if one is given twice: nothing follows from that.
std::vector<Real> descending_sizes(std::vector<Real> cells);

}  // namespace terp
