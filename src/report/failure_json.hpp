// Events of a run as parts of the report's document (docs/report_format.md). Words are made of them on the page.
#pragma once

#include "results/run_results.hpp"

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

namespace terp {

/// An object with the keys passes, events and warnings. first_surface: x, y of the ground at t = 0 [m], shape [n, 2].
nlohmann::ordered_json failure_json(
    const RunResults& run, std::span<const float> first_surface, const std::vector<std::string>& warnings);

}  // namespace terp
