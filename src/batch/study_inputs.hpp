// The files that a study file itself names: in `set`, in [fragility.set], in `coarse`, in the mean of a field, in the
// values of a sweep. Not for: those that the case names (io/case/other_files).
#pragma once

#include "io/case/document.hpp"
#include "model/case/input_file.hpp"

#include <string>
#include <vector>

namespace terp {

/// Puts the digits of each file in the place of its name, so that what counts is what stands in it. folder: of the
/// case, from which names count. Throws FileError where a file cannot be read.
void name_digits_of_files(Node& study, const std::string& folder);

/// Names the files as their copies in the folder of a study are called, and lists them.
std::vector<InputFile> name_copies_of_files(Node& study, const std::string& folder);

}  // namespace terp
