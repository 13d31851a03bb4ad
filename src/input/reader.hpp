// Walks the file with the table of keys beside it: every key must be declared, every required one present.
#pragma once

#include "input/document.hpp"
#include "input/values.hpp"
#include "simulation/case.hpp"

namespace terp {

/// Fills the case from the file and reports every unknown, missing and wrong key.
void read_values(const Node& root, Case& values, Findings& findings);

}  // namespace terp
