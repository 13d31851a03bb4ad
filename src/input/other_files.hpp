// The other files that a case names: mesh.file and body.points, relative to the case file.
// Not for: what is in them (mesh, points).
#pragma once

#include "base/errors.hpp"
#include "input/document.hpp"

#include <string>
#include <vector>

namespace terp {

/// Adds a problem for each file that is not there or cannot be read. folder: that of the case file.
void check_files(const Node& root, const std::string& folder, std::vector<Problem>& problems);

/// Writes relative names as absolute ones, so that the case reads the same from any folder. True if there were any.
bool make_files_absolute(Node& root, const std::string& folder);

/// A file in the same folder with that ending and a name much like it; empty if there is none.
std::string similar_file(const std::string& path, const std::string& ending);

}  // namespace terp
