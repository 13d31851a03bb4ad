// Squares of a grid that lies in any direction, as many as fit into a polygon: the inside of a turned mesh.
// Not for: the strip between them and the polygon. gmsh fills it (geo_text.hpp).
#pragma once

#include "math/types.hpp"

#include <vector>

namespace terp {

struct TurnedSquares {
  std::vector<Vec<2>> places;                 ///< corners [m]
  std::vector<std::array<Index, 2>> lines;    ///< sides, from place to place
  std::vector<std::array<Index, 4>> squares;  ///< lines counter-clockwise; line k is written k + 1, or -(k + 1) if it
                                              ///< runs the other way
  std::vector<std::vector<Index>> outline;    ///< loops of lines, squares to the left
};

/// polygon: counter-clockwise [m]; side: of a square [m]; turn: of its first side against x, counter-clockwise [deg];
/// clearance: least distance of a corner from the polygon [m], at least half a side. The grid has a corner in the
/// middle of the box around the polygon. Squares never touch at a corner alone. Empty if none fits.
TurnedSquares turned_squares(const std::vector<Vec<2>>& polygon, Real side, Real turn, Real clearance);

}  // namespace terp
