// The quality of a mesh, and the cost of its smallest cell: the lines that `terp check` prints. Not for: refusing a
// mesh (check_mesh.hpp).
#pragma once

#include "mpm/mesh/mesh.hpp"

#include <string>

namespace terp {

/// A number of one cell.
struct CellValue {
  Real value = 0.0;
  Index cell = 0;
  std::string name;  ///< as in mesh_error.hpp
  Vec<2> centre{};   ///< [m]
};

struct MeshQuality {
  Index n_cells = 0;
  Index n_nodes = 0;
  Index n_parts = 0;            ///< pieces that share no side; 1 for an ordinary mesh
  CellValue smallest_altitude;  ///< L_e [m], decides the time step (reading R19)
  CellValue
      smallest_jacobian;       ///< smallest scaled Jacobian: sine of the sharpest corner's angle; 1 for a rectangle [-]
  CellValue largest_aspect;    ///< longest side over altitude; 1 for a square [-]
  Real median_altitude = 0.0;  ///< [m]
  Real cost = 1.0;             ///< median altitude over the smallest: factor on the number of steps [-]
};

/// Cost from which one cell is worth a warning.
inline constexpr Real costly = 3.0;

/// Of a connected mesh with at least one cell.
MeshQuality measure_quality(const Mesh<2>& mesh);

/// Lines "  name           value", each with a newline at its end, and warnings after them.
std::string describe(const MeshQuality& quality);

}  // namespace terp
