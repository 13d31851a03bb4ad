// The sides of a mesh, measured, and their conditions: for `terp check`, its picture, and warnings.
#pragma once

#include "model/bodies/body_outline.hpp"
#include "model/case/case.hpp"

#include <string>

namespace terp {

/// Length of a side [m] and its mean outward normal, each edge by its length.
struct SideShape {
  Real length = 0.0;
  Vec<2> normal{0.0, 0.0};
};
SideShape shape_of_side(const Mesh<2>& mesh, const NamedSide& side);

/// The two ends of an edge in the order of its cell, which lies to the left.
Side edge_of(const Mesh<2>& mesh, CellSide at);

/// The condition of a side of the mesh; of kind free if the case gives none.
SideCondition condition_of(const Case& description, const std::string& side);

}  // namespace terp
