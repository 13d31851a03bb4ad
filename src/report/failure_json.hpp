// Events, story, checks and audit of a run as parts of the report's document (docs/report_format.md).
#pragma once

#include "results/run_results.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace terp {

/// An object with the keys passes, events, story, warnings, checks and audit. warnings: further ones.
nlohmann::ordered_json failure_json(const RunResults& run, const std::vector<std::string>& warnings);

}  // namespace terp
