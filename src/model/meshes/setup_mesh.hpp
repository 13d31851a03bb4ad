// The background mesh that a case asks for, whichever way it says so.
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "model/case/case.hpp"

namespace terp {

/// Builds, reads or has gmsh make the mesh, and checks it. Throws InputError with the key at fault.
Mesh<2> build_mesh(const Case& description);

/// Side of a square of the cells' mean area [m].
Real typical_cell_size(const Mesh<2>& mesh);

/// Smallest and largest x of all nodes [m].
Vec<2> extent_in_x(const Mesh<2>& mesh);

}  // namespace terp
