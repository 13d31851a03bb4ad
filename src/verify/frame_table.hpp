// A frame as a table of named numbers, one row per material point, for the formulas of a field.
#pragma once

#include "run/loop/observer.hpp"

#include <string>
#include <vector>

namespace terp {

/// t, x, y; x0, y0 (where the point was at t = 0), ux, uy, vx, vy; sxx syy szz sxy [Pa] and p = their mean, tension
/// positive; exx eyy ezz exy; and every field of one component by its own name.
std::vector<std::string> names_of(const Frame& frame);

/// The numbers of one point, in the order of the names.
void read_row(const Frame& frame, std::size_t point, std::vector<Real>& row);

}  // namespace terp
