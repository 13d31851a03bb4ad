// Reads a background mesh from a gmsh file: cells, named sides, named regions.
// Not for: the bytes of the file (msh_content.hpp), or calling gmsh.
#pragma once

#include "model/meshes/mesh_error.hpp"

namespace terp {

/// MSH 4.1, text or binary, read directly; other versions of MSH, and files that end in .unv, .bdf, .nas or .vtk, as
/// gmsh converts them. Quadrilaterals in a plane z = constant, lengths in m. Checked (check_mesh) and connected.
///
/// cells    in the order of a Hilbert curve through their centres: near numbers are near in space (speed)
///          a surface (gmsh's elementary entity) of clockwise quads alone is turned round; one among others is a fault
/// nodes    in file order, those of no quad left out
/// sides    physical groups of dimension 1; each line must be the side of exactly one cell
/// regions  physical groups of dimension 2
/// A group without a name is called by its number. Groups of one name are one. Throws MeshError.
Mesh<2> read_gmsh(const std::string& path);

/// The same from the text of a file; path: for messages.
Mesh<2> read_gmsh_text(const std::string& path, std::string text);

}  // namespace terp
