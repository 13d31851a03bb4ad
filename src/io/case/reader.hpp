// Walks the file with the table of keys beside it: every key must be declared, every required one present.
// Then what follows from what was read: parameters that were left out, and the cases of the stages.
#pragma once

#include "io/case/document.hpp"
#include "io/case/values.hpp"
#include "model/case/case.hpp"

namespace terp {

/// Fills the case from the file, with what follows from keys that are left out, and reports every unknown, missing and
/// wrong key.
void read_values(const Node& root, Case& values, Findings& findings);

/// Fills in what the section of a material left out: from ratios (su_residual from sensitivity), defaults, and other
/// parameters. One that follows from a field is a field. Problems: a ratio beside the parameter that it stands for.
std::vector<Problem> complete_parameters(const MaterialType& law, MaterialCase& material);

/// Fills in StageCase::changed, the case with what each stage sets, of a case without faults. `document`: where its
/// keys stand. Throws CaseError at the first stage that sets what may not change, or a value that is not allowed. Adds
/// warnings of the stages.
void read_stages(const Document& document, Case& values, std::vector<Problem>& warnings);

}  // namespace terp
