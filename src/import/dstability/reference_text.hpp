// What a file stores of a stage, beside what Terp has: its slip planes as tables of the case, which the report page
// draws over its own and `terp check` compares in strength, and its slices in words.
#pragma once

#include "import/dstability/case_text.hpp"
#include "import/dstability/project.hpp"
#include "import/dstability/soil_strength.hpp"

namespace terp {

/// A table [[reference.slip_planes]] for each stored result of the stage that has a slip plane; the name of one that
/// belongs to another section, or was computed with other strengths than those of the case, says so. The factor of
/// other strengths is a comment: nothing compares it with a run. Those of the case have S_u at their slices.
std::vector<CaseTableText> reference_texts(
    const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis);

/// How far what is stored at the slices of the stage is from what the file gives by docs/dstability.md: a sentence per
/// result.
std::vector<std::string> slices_in_words(const StixProject& project, std::size_t scenario, std::size_t stage);

}  // namespace terp
