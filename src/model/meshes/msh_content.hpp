// What a gmsh mesh file holds, as it stands there: MSH 4.1, text or binary; other formats as gmsh converts them.
// Not for: cells, sides and regions (gmsh_file.hpp).
#pragma once

#include "math/types.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace terp {

/// The element types that Terp tells apart, by gmsh's numbers.
inline constexpr int msh_line = 1, msh_quad = 3, msh_point = 15;

struct MshElement {
  std::int64_t number;                ///< gmsh's
  int type;                           ///< gmsh's
  int n_nodes;                        ///< of the type; the first four are kept
  std::array<std::int64_t, 4> nodes;  ///< gmsh's node numbers
  Index groups;                       ///< into MshContent::group_sets
  int entity;                         ///< gmsh's number of the curve or surface it was made from
};

/// A point (dimension 0), curve (1) or surface (2) of the geometry.
struct MshEntity {
  int dimension, number;
  auto operator<=>(const MshEntity&) const = default;
};

struct MshContent {
  std::vector<std::int64_t> node_numbers;   ///< gmsh's, in file order
  std::vector<std::array<Real, 3>> places;  ///< of the nodes, in file order
  std::vector<MshEntity> node_entities;     ///< what each node was made on
  std::vector<std::size_t> node_bytes;      ///< where the x of each node begins in the file
  std::vector<MshElement> lines, quads;     ///< in file order
  std::vector<MshElement> others;           ///< the first few elements that are neither, nor points
  std::int64_t n_others = 0;
  std::vector<std::vector<int>> group_sets;                ///< numbers of the physical groups an element belongs to
  std::map<std::pair<int, int>, std::string> group_names;  ///< by dimension and number
};

/// "triangle", "line with 3 nodes"; empty for a type that Terp has never heard of.
std::string msh_type_name(int type);

/// Throws MeshError with the path and the line (text) or byte (binary) of what it cannot read. path: for messages;
/// text: the whole file.
MshContent read_msh(const std::string& path, std::string text);

/// True for older files of gmsh, by their first words, and for those of others that it can read, by their ending: .unv,
/// .bdf, .nas, .vtk. text: the whole file.
bool needs_conversion(const std::string& path, const std::string& text);

/// The file as gmsh converts it to MSH 4.1. Throws MeshError, also where gmsh is not installed.
MshContent convert_by_gmsh(const std::string& path);

}  // namespace terp
