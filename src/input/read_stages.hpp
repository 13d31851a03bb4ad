// The cases of the stages of a run: the case with what each stage sets.
#pragma once

#include "base/errors.hpp"
#include "input/document.hpp"
#include "simulation/case.hpp"

namespace terp {

/// Fills in StageCase::changed of a case without faults. `document`: where its keys stand. Throws CaseError at the
/// first stage that sets what may not change, or a value that is not allowed. Adds warnings of the stages.
void read_stages(const Document& document, Case& values, std::vector<Problem>& warnings);

}  // namespace terp
