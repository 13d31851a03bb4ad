// Where a slide begins at the ground: the upper end of its slip surface, and on which part of the slope that is.
#pragma once

#include "simulation/summary.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace terp {

/// The ground is that of t = 0.
struct EntryPoint {
  Real x = 0.0, y = 0.0;  ///< of the ground above the upper end of the slip surface [m]
  /// "beyond_crest", "crest", "upper_half" or "lower_half" of the slope that slides, by height
  std::string_view zone;
};

/// ground: x, y from left to right [m], shape [n, 2]. None without a slip surface below that ground.
std::optional<EntryPoint> entry_point(const SlideSummary& slide, std::span<const float> ground);

}  // namespace terp
