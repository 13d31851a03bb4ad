// Mesh files in other formats than MSH 4.1, converted by gmsh.
#pragma once

#include "meshing/msh_content.hpp"

namespace terp {

/// True for older files of gmsh, by their first words, and for those of others that it can read, by their ending: .unv,
/// .bdf, .nas, .vtk. text: the whole file.
bool needs_conversion(const std::string& path, const std::string& text);

/// The file as gmsh converts it to MSH 4.1. Throws MeshError, also where gmsh is not installed.
MshContent convert_by_gmsh(const std::string& path);

}  // namespace terp
