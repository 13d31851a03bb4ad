// P(F|I) over the level of the water, from the ground that the slides of a study left: a study of one level, or of few,
// says of all others what share of its slides they would flood.
#pragma once

#include "batch/estimates.hpp"

#include <string>
#include <vector>

namespace terp {

struct HeightPlace {
  Real level;           ///< of the water [m]
  EventEstimate event;  ///< the slides that leave less ground than that; bounds at the confidence of the study
};

/// At even distances: from the lowest ground that a slide left to the highest, or between the levels of a load, where
/// it goes over from the slides of one level to those of the next. Empty where it says nothing: without a water level,
/// without slides, for another load than a water level, and for estimators whose realisations do not count alike.
std::vector<HeightPlace> flood_after_slide_over_level(const Study& study, const Realisations& rows);

/// "  P(F|I) ... 0.1 at 3.62 m" for a terminal; empty where there is no curve.
std::string height_curve_text(const std::vector<HeightPlace>& curve);

/// flood_after_slide.csv: level, P and its bounds.
std::string height_curve_csv(const std::vector<HeightPlace>& curve);

}  // namespace terp
