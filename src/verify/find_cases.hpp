// Finds verification cases: folders with an expected.toml.
#pragma once

#include <string>
#include <vector>

namespace terp {

/// cases/verification beside the program, in a folder above it, or in its share/terp; throws FileError with the places
/// that were tried.
std::string find_cases_folder();

/// Names of the cases in a folder, sorted.
std::vector<std::string> names_of_cases(const std::string& folder);

/// The requested cases, or all; a name that ends in * means all that begin so. Throws FileError for an unknown name.
std::vector<std::string> choose_cases(const std::string& folder, const std::vector<std::string>& wanted);

}  // namespace terp
