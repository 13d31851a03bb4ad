// The keys of model = "library", and the library opened.
#pragma once

#include "io/case/keys.hpp"
#include "io/case/values.hpp"

namespace terp {

/// Keys of [material.NAME] that say which library a law comes from, and what it is given.
std::vector<KeyInfo> library_keys();

/// Opens the libraries of the materials and asks them for their laws. Libraries whose file is not there are left:
/// check_files tells of them. root: of the case file that the values are read from.
void load_libraries(const Node& root, Case& values, std::vector<Problem>& problems);

/// What a stage may not change of a law from a library: all but its parameters and moduli.
void check_libraries_of_stage(const Case& before, const Case& now, std::vector<Problem>& problems);

/// Refuses soil that a stage places, or gives this law, beside soil that has it, where the first call of a law would
/// be one for both. before: the case until then.
void check_first_calls(const Case& before, const Case& now, std::size_t stage, std::vector<Problem>& problems);

}  // namespace terp
