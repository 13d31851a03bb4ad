// The keys of model = "library", and the library opened.
#pragma once

#include "input/keys.hpp"
#include "input/values.hpp"

namespace terp {

/// Keys of [material.NAME] that say which library a law comes from, and what it is given.
std::vector<KeyInfo> library_keys();

/// Opens the libraries of the materials and asks them for their laws. Libraries whose file is not there are left:
/// check_files tells of them.
void load_libraries(Case& values, std::vector<Problem>& problems);

/// What a stage may not change of a law from a library: all but its parameters.
void check_libraries_of_stage(const Case& before, const Case& now, std::vector<Problem>& problems);

}  // namespace terp
