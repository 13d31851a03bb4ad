// The uniform loads of a stage as tables of a case.
// Not for: what they do to stresses of the file (section.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/case_text.hpp"
#include "import/dstability/project.hpp"
#include "import/dstability/section_layout.hpp"

namespace terp {

struct LoadTexts {
  std::vector<CaseTableText> tables;  ///< [[load]]
  std::vector<std::string> sets;      ///< of the analysed stage: those that the first one does not have
  std::vector<Sentence> assumed;      ///< for the report
  std::vector<Sentence> left_out;     ///< the same
};

/// first: the first stage of the case; null: the stage is the only one.
LoadTexts load_texts(const StixStage& stage, const StixStage* first, const SectionLayout& layout);

}  // namespace terp
