// The section as it stands at t = 0: its surface, and the slopes that may slide. Definitions: docs/formats.md.
#pragma once

#include "mpm/points/surface.hpp"

namespace terp {

enum class Facing { right, left };

/// +1 or -1: the sign of the way out of a slope.
inline Real outwards(Facing facing) { return facing == Facing::right ? 1.0 : -1.0; }

/// A slope of the first surface, from the crest down to its foot.
struct Slope {
  Facing facing = Facing::right;
  Index first = 0,
        last = 0;     ///< columns of the crest, and of the plateau that falls gently from it: first ... last - 1
  Real height = 0.0;  ///< of the crest over the foot, where a plateau falls from it of the plateau's edge [m]
  Real relief = 0.0;  ///< by which it is judged whether the ground stands: of the section, with such a plateau
                      ///< the height [m]
  Real crest = 0.0;   ///< edge of the crest [m]
  Real toe = 0.0;  ///< where the slope has come down to the level of its foot; with a free toe the end of its soil, by
                   ///< columns [m]
  bool free_toe = true;  ///< no soil at the side of the mesh; otherwise it fills the mesh to there
};

struct Section {
  Columns columns;
  std::vector<Real> heights;  ///< [m], shape [columns.n]; minus infinity where there is no soil
  Real base = 0.0;            ///< height of the lowest point [m]
};

/// The surface of the ground as it is.
Section look_at_section(const Mesh<2>& mesh, const PointBlocks<2>& points, Columns columns, Ground ground = {});

/// Columns that cover `left` to `right` [m].
Columns columns_between(Real left, Real right, Real width);

/// Height of the highest surface over the lower of the feet on both sides: the ground there, or the lowest point where
/// no soil is [m].
Real relief(const Section& section);

/// True if the relief is less than a column is wide: what the points and the cells make of level ground is no slope.
bool is_flat(const Section& section);

/// The slopes of a section, that to the right first: none, one or two.
std::vector<Slope> find_slopes(const Section& section);

/// Displacement from which on soil counts as moved: a twentieth of the relief, or of the height of a section without
/// any [m].
Real moved_distance(const Section& section);

}  // namespace terp
