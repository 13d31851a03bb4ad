// The script from which gmsh makes a mesh, and the target size that it asks for.
// Not for: running gmsh. generate.hpp does.
#pragma once

#include "model/meshes/planar_map.hpp"
#include "model/meshes/polygon_mesh.hpp"

#include <string>

namespace terp {

/// Triangles of twice the size, paired where that is good, then everything halved.
struct Recipe {
  int algorithm;      ///< gmsh's Mesh.Algorithm for the triangles
  int recombination;  ///< gmsh's Mesh.RecombinationAlgorithm for the pairs
  int variant;        ///< 0: sizes as asked; otherwise they waver by 3 %, for each number in another way
  Real size_factor;   ///< of the triangles, so that the median cell has the target size [-], measured
};

/// Target size at a place: the smallest that the mesh or a refinement asks for [m].
Real target_size(const PolygonMesh& mesh, Vec<2> x);

/// The same numbers give the same text to the last character. The squares of a turned mesh have numbers beyond those
/// of the lines and faces of the map. Throws MeshError if none fits.
std::string geo_text(const PolygonMesh& mesh, const PlanarMap& map, const Recipe& recipe);

}  // namespace terp
