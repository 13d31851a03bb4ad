// What other commands left beside the folder of a run, of the same case: parts of the report's document.
#pragma once

#include "io/results/run_results.hpp"

#include <nlohmann/json_fwd.hpp>

namespace terp {

/// The factor of safety of the same case, to the letter, where `terp stability` or `terp assess` left it: in the folder
/// stability beside that of the run. Else null.
nlohmann::ordered_json stability_beside(const RunResults& run);

/// What the outcome turns on, where `terp converge --what-decides` solved this run among others: beside its folder.
nlohmann::ordered_json depends_json(const RunResults& run);

}  // namespace terp
