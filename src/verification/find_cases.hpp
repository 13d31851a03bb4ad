// Which verification cases there are: folders with an expected.toml.
#pragma once

#include <string>
#include <vector>

namespace terp {

/// cases/verification beside the program, in a folder above it, or in its share/terp; throws FileError with the places
/// that were tried.
std::string find_cases_folder();

/// Names of the cases in a folder, sorted.
std::vector<std::string> names_of_cases(const std::string& folder);

/// Those that were asked for, or all; a name that ends in * stands for all that begin so. Throws FileError for a name
/// that is not there.
std::vector<std::string> choose_cases(const std::string& folder, const std::vector<std::string>& wanted);

}  // namespace terp
