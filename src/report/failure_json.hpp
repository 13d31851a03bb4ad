// Events, story, checks and audit of a run as parts of the report's document (docs/report_format.md).
#pragma once

#include "output/json_text.hpp"
#include "results/run_results.hpp"

#include <string>
#include <vector>

namespace terp {

/// Writes the keys events, story, warnings, checks, audit and passes into the open object. warnings: further ones.
void put_failure(JsonText& json, const RunResults& run, const std::vector<std::string>& warnings);

}  // namespace terp
