// The files that a case names, and what their copies in a run folder are called.
// Not for: what is in them (mesh, points).
#pragma once

#include <string>
#include <string_view>

namespace terp {

struct InputFile {
  std::string path, copy;
};

inline constexpr std::string_view mesh_copy =
    "mesh.msh";  ///< of `mesh.file`; those of `body.points`: points_1.csv, ...

}  // namespace terp
