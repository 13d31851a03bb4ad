// The other files that a case names: mesh.file, body.points, reference.imported and the `csv` of fields, relative to
// the case file.
// Not for: what is in them (mesh, points).
#pragma once

#include "math/errors.hpp"
#include "io/case/document.hpp"
#include "model/case/input_file.hpp"

#include <string>
#include <vector>

namespace terp {

/// Why a path is no file that can be read; empty if it is one.
std::string fault_of_file(const std::string& path);

/// Adds a problem for each file that is not there or cannot be read. folder: that of the case file.
void check_files(const Node& root, const std::string& folder, std::vector<Problem>& problems);

/// Names the files as their copies in a run folder are called, and lists them. True if a name changed.
bool name_copies(Node& root, const std::string& folder, std::vector<InputFile>& files);

/// A file in the same folder with that ending and a name much like it; empty if there is none.
std::string similar_file(const std::string& path, const std::string& ending);

}  // namespace terp
