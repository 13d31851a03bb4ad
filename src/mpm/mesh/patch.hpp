// The patch of a cell: its own sub-cells and the outer ones around them, into which the extent of its points reaches
// (mpm/kernels/overlap.hpp). Across a side the outer sub-cells are those of the neighbour that touch the side. Across a
// corner it is the one of the opposite cell, where as many cells meet as in a regular mesh.
#pragma once

#include "mpm/mesh/mesh.hpp"

namespace terp {

/// Sub-cells of a patch, in slots; outer sub-cells are also counted by themselves.
template <class Element>
struct Patch;

/// 4 x 4 slots: 4 * row + column, rows upward; the cell's own sub-cells are the middle ones.
template <>
struct Patch<Quad4> {
  static constexpr int n_slots = 16;
  static constexpr std::array<int, Quad4::n_gauss> own_slot{5, 6, 9, 10};  ///< of sub-cell g

  /// Outer sub-cells: 2 s and 2 s + 1 across side s, at its first and second corner; 8 + q across corner q.
  static constexpr int n_outer = 12, n_across_sides = 8;
  static constexpr std::array<int, n_outer> outer_slot{1, 2, 7, 11, 14, 13, 8, 4, 0, 3, 15, 12};
  /// The cell's own sub-cell that touches an outer one.
  static constexpr std::array<int, n_outer> own_beside{0, 1, 1, 3, 3, 2, 2, 0, 0, 1, 3, 2};
  /// Outer sub-cells beside the one across corner q: across the side that ends there, and the side that begins there.
  static constexpr std::array<std::array<int, 2>, Quad4::n_corners> beside_corner{{{7, 0}, {1, 2}, {3, 4}, {5, 6}}};
};

/// Where outer sub-cell k of a cell lies: n_outer * (the other cell) + (the outer sub-cell of that cell which touches
/// it from this cell), or `outside`. Mutual: the partner of the partner is where it began. Shape [n_cells][n_outer].
using PatchPartners = std::vector<std::array<Index, Patch<Quad4>::n_outer>>;

/// The same between blocks of points: n_slots * (the other block) + the slot in its patch, or -1 where there is none.
using BlockPartners = std::array<Index, Patch<Quad4>::n_outer>;

PatchPartners find_patch_partners(const Mesh<2>& mesh);

}  // namespace terp
