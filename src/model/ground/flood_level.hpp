// The level that the ground is judged against, and the end of the section at which the river is. docs/flood.md.
// Not for: what the ground is (ground_section), nor the verdict (run/measure/flood.cpp).
#pragma once

#include "model/ground/section.hpp"
#include "model/case/case.hpp"

#include <limits>
#include <optional>
#include <string>

namespace terp {

struct Model;

struct FloodLevel {
  Real value = std::numeric_limits<Real>::quiet_NaN();  ///< [m]; NaN: none, and nothing is judged
  std::string origin = {};                              ///< where it comes from, in words
  std::optional<Facing> river = {};                     ///< as the case says, or where the free water stands higher
  bool at_both_ends = false;                            ///< the free water stands at both ends, equally high

  bool is_known() const { return value == value; }
};

/// Whether a formula of the time says what a water of the run is: then no level follows from it.
bool changes_with_time(const Case& whole);

/// The level of [flood] or, where it gives none, the highest that the free water at the river's end has in any
/// situation that the case asks for. Of a case and the model of one of its stages.
FloodLevel find_flood_level(const Case& whole, const Model& model);

}  // namespace terp
