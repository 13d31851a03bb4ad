// What the reader of case files and the conditions of the nodes need of the table of kinds besides: the numbers that a
// kind takes, and what becomes of them at a node. Both stand in side_kind.cpp, beside the kinds.
#pragma once

#include "mpm/features/side_kind.hpp"
#include "soil/laws/material.hpp"

namespace terp {

/// A number of a boundary condition: a key of the side's table, and the member that has it.
struct SideNumber {
  std::string_view name, unit;  ///< "-" if it has none
  Range range;
  Range usual;  ///< outside: warn
  std::string_view meaning;
  Real SideCondition::*at;
};

std::span<const SideNumber> side_numbers();

/// The condition of a side at its node at x. normal: outward, of any length; half_length: see NodeSide.
NodeSide node_side(const SideCondition& given, Vec<2> normal, Real half_length, Vec<2> x);
/// Two parts of one base at the node between them: the push is shared by their half lengths.
NodeSide joined(const NodeSide& a, const NodeSide& b);

}  // namespace terp
