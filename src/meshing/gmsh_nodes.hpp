// The nodes and quadrilaterals of a file that gmsh has just written (MSH 4.1, binary), so that nodes can be moved in
// place. Not for: files from users. gmsh_file.hpp reads those, with all their checks.
#pragma once

#include "base/types.hpp"

#include <string>
#include <vector>

namespace terp {

struct GmshNodes {
  std::vector<Vec<2>> nodes;   ///< [m]
  std::vector<int> dimension;  ///< of the thing a node lies on: 0 a place, 1 a line, 2 a face; shape [n_nodes]
  std::vector<Index> number;   ///< of that place, line or face in the script, from 1; shape [n_nodes]
  std::vector<std::array<Index, 4>>
      cells;  ///< corners in gmsh's order: counter-clockwise unless a cell is inverted, for our faces are
  std::vector<std::size_t> offset;  ///< of a node's x in the bytes of the file, shape [n_nodes]
  bool all_quads = true;            ///< no triangle is left
};

/// Throws MeshError if the bytes are not what gmsh writes.
GmshNodes find_nodes(const std::string& bytes);

/// Writes `nodes` over the coordinates in `bytes`.
void put_nodes(const GmshNodes& file, std::string& bytes);

}  // namespace terp
