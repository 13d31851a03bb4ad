// Values of keys of the case with formulas in them: of the level of a load, or of numbers that are drawn and have a
// name. A text that has one of these names as a word of its own is a formula; other texts stay as they are.
#pragma once

#include "io/case/document.hpp"

#include <string>
#include <utility>
#include <vector>

namespace terp {

/// Keys of the case in order, with their values.
using KeyValues = std::vector<std::pair<std::string, Node>>;

bool has_formula(const Node& value, const std::vector<std::string>& names);

/// The value with its formulas as numbers. values: of the names, in their order. Throws ExpressionError.
Node with_numbers(Node value, const std::vector<std::string>& names, const std::vector<Real>& values);

/// KEY=VALUE of each, as of --set. Throws ExpressionError.
std::vector<std::string> changes_with_numbers(
    const KeyValues& keys, const std::vector<std::string>& names, const std::vector<Real>& values);

}  // namespace terp
