// Options of [method] that do nothing, or work against each other.
#pragma once

#include "input/document.hpp"
#include "input/values.hpp"
#include "simulation/case.hpp"

namespace terp {

/// Adds warnings about options that the file sets.
void check_method(const Node& root, const Case& values, std::vector<Problem>& warnings);

}  // namespace terp
