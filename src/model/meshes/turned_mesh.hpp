// The background mesh of a case with its cells in another direction, as a file.
#pragma once

#include "model/case/case.hpp"

#include <string>

namespace terp {

/// Why the cells of a case cannot be turned, as a clause; empty: they can.
std::string why_not_turned(const Case& description);

/// Path of a mesh file of the same place, sides and size of cells, made of squares in the direction `turn` against x,
/// counter-clockwise [deg, between -90 and 90], and along the sides of a strip by gmsh (docs/methods.md, section 1). It
/// lies in the cache of generate_mesh. Throws MeshError where gmsh or the cache is missing, or no square fits.
std::string turned_mesh_file(const Case& description, Real turn);

}  // namespace terp
