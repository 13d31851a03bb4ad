// Strengths of a case as its file writes them, times a factor: numbers, formulas, tables and fields, in soils, their
// parts, sides and stages. Not for: which of them decide (what_decides).
#pragma once

#include "io/case/document.hpp"

#include <limits>
#include <string>
#include <vector>

namespace terp {

struct StrengthLever {
  const char* name;
  std::vector<std::string_view> keys;  ///< parameters of a soil, or keys of a side, that change together
  std::string_view within;             ///< key of a field of SHANSEP or of a yield stress; empty: the whole value
  Real less, more;                     ///< factors
  Real least = 0.0, greatest = std::numeric_limits<Real>::infinity();  ///< values that the key may have
};

const std::vector<StrengthLever>& strength_levers();

struct ScaledStrength {
  std::vector<std::string> changes;  ///< KEY=VALUE
  std::vector<std::string> left;     ///< keys whose form cannot be scaled, with the reason
};

/// root: of a case file.
ScaledStrength scale_strength(const Node& root, const StrengthLever& lever, Real factor);

/// Keys of strengths that belong to no lever: of laws in libraries.
std::vector<std::string> strengths_without_lever(const Node& root);

}  // namespace terp
