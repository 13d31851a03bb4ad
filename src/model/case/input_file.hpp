// The files that a case names, and what their copies in a run folder are called.
// Not for: what is in them (mesh, points).
#pragma once

#include <string>
#include <string_view>

namespace terp {

struct InputFile {
  std::string path, copy;
};

/// What the copy of `mesh.file` is called, by its ending; those of `body.points` are points_1.csv, points_2.csv, ...,
/// of libraries library_1.so, library_2.so, ...
inline constexpr std::string_view mesh_copies[] = {"mesh.msh", "mesh.unv", "mesh.bdf", "mesh.nas", "mesh.vtk"};

/// What the copy of `reference.imported` is called.
inline constexpr std::string_view copy_of_import = "imported.toml";

}  // namespace terp
