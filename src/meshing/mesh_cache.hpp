// The folder where generated meshes are kept, by content, and files that appear in it whole or not at all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Path of the kept file, whether it is there or not: ${XDG_CACHE_HOME:-~/.cache}/terp/meshes/<key>.msh, on Windows in
/// %LOCALAPPDATA%; empty if neither variable is set.
std::string cached_mesh_path(const std::string& key);

/// Paths of all kept files whose keys start like this, the newest first.
std::vector<std::string> cached_meshes(const std::string& start_of_key);

/// Empty if the file cannot be read.
std::string bytes_of(const std::string& path);

/// Keeps `bytes` under the key. False if the cache cannot be written.
bool keep_mesh(const std::string& key, const std::string& bytes);

}  // namespace terp
