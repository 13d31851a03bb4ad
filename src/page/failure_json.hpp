// Events of a run as parts of the report's document (docs/report_format.md). Words are made of them on the page.
#pragma once

#include "io/results/run_results.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace terp {

/// Where a slide begins at the ground of t = 0.
struct EntryPoint {
  Real x = 0.0, y = 0.0;  ///< where the slip surface comes up to the ground [m]
  /// "beyond_crest", "crest", "upper_half" or "lower_half" of the slope that slides, by height
  std::string_view zone;
};

/// Of the slip surface as it was when the slide was first seen. Its upper end lies in the last column that shears: from
/// there the line goes on to the ground, as steep as it was over the last height of the gap, at least at 45 degrees, as
/// soil that gives way does: at most its depth off. ground: x, y from left to right [m], shape [n, 2]. None without a
/// slip surface, where its end lies deeper below the ground than two fifths of the slope's height, or above it, and of
/// a slide that was not seen before it sheared fastest: then nobody knows.
std::optional<EntryPoint> entry_point(const SlideSummary& slide, std::span<const float> ground);

struct FirstGround {
  std::span<const float> surface;  ///< x, y [m], shape [n, 2]
  std::span<const float> outline;  ///< of the bodies, as of first_outline
  Real column = 0.0;               ///< width of the columns in which crests are seen [m]
};

/// An object with the keys passes and events.
nlohmann::ordered_json failure_json(const RunResults& run, const FirstGround& first);

}  // namespace terp
