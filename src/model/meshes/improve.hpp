// Moves the nodes of quadrilaterals so that the worst cells grow: the smallest altitude sets the time step of a whole
// run.
#pragma once

#include "math/types.hpp"

#include <vector>

namespace terp {

struct Freedom {
  int n = 0;               ///< 0: fixed; 1: along a line; 2: anywhere
  Vec<2> along{0.0, 0.0};  ///< unit vector of the line, if n is 1
};

/// nodes [m], shape [n_nodes], in and out; cells counter-clockwise, shape [n_cells]; freedom, shape [n_nodes];
/// target: wanted size of each cell [m], shape [n_cells].
/// One thread, fixed order: the same bits each time.
void enlarge_altitudes(const std::vector<std::array<Index, 4>>& cells, const std::vector<Freedom>& freedom,
    const std::vector<Real>& target, std::vector<Vec<2>>& nodes);

/// Smallest height of a corner over a side that it does not lie on [m]; not positive if the cell is not convex.
Real smallest_altitude(const std::array<Index, 4>& cell, const std::vector<Vec<2>>& nodes);

}  // namespace terp
