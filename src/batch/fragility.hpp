// The fragility curve of a study: P of the events at each level of the load, and over its distribution.
#pragma once

#include "batch/estimates.hpp"

#include <optional>
#include <vector>

namespace terp {

struct LevelEstimate {
  Real level = 0.0;
  EventEstimate slide, flood, flood_after_slide;  ///< P(I|h), P(F|h), P(F|I, h); empty where floods are not judged
};

/// Of an event over all levels that the load may have.
struct CurveIntegral {
  Real probability = 0.0;  ///< P(h) linear between the levels, constant beyond the first and the last
  Bounds of_line = {};     ///< what the sample leaves open of that
  /// Of any P(h) that does not fall, whatever it does between the levels and beyond; none: the sample says that it
  /// falls.
  std::optional<Bounds> rising = {};
  Real beyond = 0.0;          ///< part of the probability that comes from loads beyond the first and last level
  Real beyond_at_most = 0.0;  ///< the same part of of_line.high
};

struct FragilityCurve {
  std::vector<LevelEstimate> levels;
  bool judges_flood = false;
  std::optional<CurveIntegral> slide, flood;  ///< none: the load has no distribution
  /// Samples with an event at a level that is gone at the next one that was solved.
  Index n_falling_slides = 0, n_falling_floods = 0;
};

/// The study must have a load. Bounds of a level are those of the study's confidence; bounds of the integrals hold at
/// all levels at once with that confidence (Bonferroni).
FragilityCurve estimate_fragility(const Study& study, const Realisations& rows);

/// Weights of the levels, with which a curve that is linear between them is integrated over a distribution. Sum: 1.
std::vector<Real> level_weights(const std::vector<Real>& levels, const Distribution& distribution);

/// beta = -Phi^-1(P). Infinite where P is 0 or 1.
Real reliability_index(Real probability);

}  // namespace terp
