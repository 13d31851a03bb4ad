// A mesh of quadrilaterals from a polygon, made by gmsh (Debian's program, run as a separate process) and kept for the
// next time.
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "model/meshes/polygon_mesh.hpp"

#include <string>

namespace terp {

/// Time that gmsh may take [s].
struct GmshTimes {
  double recipe = 600.0;    ///< for one recipe
  double all = 900.0;       ///< for all recipes together
  double first_word = 5.0;  ///< before the user is told that it is at work
};

struct GeneratedMesh {
  std::string path;  ///< where it is kept; empty if the cache cannot be written
  Mesh<2> mesh;      ///< as read_gmsh reads it
};

/// A mesh file (MSH 4.1, binary) of quadrilaterals, with the named sides and the region "domain". Made at the first
/// call, later found by its content in ${XDG_CACHE_HOME:-~/.cache}/terp/meshes. Places of followed outlines closer to
/// each other, to a corner or to an edge than a fifth of a cell count as one for the mesh (not for the bodies), lest a
/// sliver sets the time step. The same input and the same gmsh give the same bytes. A kept file that cannot be read is
/// made anew; where gmsh is not installed, one that another version made is taken. Throws MeshError with what to do.
GeneratedMesh generate_mesh(const PolygonMesh& mesh, const GmshTimes& times = {});

}  // namespace terp
