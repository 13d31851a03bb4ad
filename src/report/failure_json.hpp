// Events of a run as parts of the report's document (docs/report_format.md). Words are made of them on the page.
#pragma once

#include "results/run_results.hpp"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace terp {

struct FirstGround {
  std::span<const float> surface;  ///< x, y [m], shape [n, 2]
  std::span<const float> outline;  ///< of the bodies, as of first_outline
  Real column = 0.0;               ///< width of the columns in which crests are seen [m]
};

/// An object with the keys passes and events.
nlohmann::ordered_json failure_json(const RunResults& run, const FirstGround& first);

}  // namespace terp
