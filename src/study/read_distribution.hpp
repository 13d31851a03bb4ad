// A distribution as a study file writes it: `distribution` and what it needs.
#pragma once

#include "input/values.hpp"
#include "study/distribution.hpp"

#include <string>

namespace terp {

/// Keys of a distribution beside `distribution` itself.
std::vector<std::string> distribution_keys();

/// table: that of the random number; path: where it stands; unit: of the key that is drawn. Adds problems.
Distribution read_distribution(const Node& table, const std::string& path, const std::string& unit, Findings& findings);

}  // namespace terp
