// The slip planes that a file stores for a stage, as tables of the case: the report page draws them over its own.
#pragma once

#include "dstability/case_text.hpp"
#include "dstability/project.hpp"

namespace terp {

/// A table [[reference.slip_planes]] for each stored result of the stage that has a slip plane; the name of one that
/// belongs to another section says so.
std::vector<CaseTableText> reference_texts(const StixProject& project, std::size_t scenario, std::size_t stage);

}  // namespace terp
