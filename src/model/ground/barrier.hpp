// How much of the ground still stands between river and land: its height, and its width at a level.
// Definitions: docs/flood.md. Not for: slides (crest.hpp), nor the verdict (run/measure/flood.cpp).
#pragma once

#include "mpm/points/ground.hpp"
#include "model/ground/section.hpp"
#include "mpm/points/surface.hpp"
#include "mpm/mesh/mesh.hpp"

#include <optional>
#include <vector>

namespace terp {

struct GroundQuestion {
  Columns columns;                   ///< the surface is looked for in the middle of each
  Ground ground = {};                ///< which materials are ground
  std::span<const int> strain = {};  ///< row of eps_eq_p by material; -1: none. Empty: none of any
  Real intact_below = 0.0;           ///< eps_eq_p below which soil is intact [-]
  Real level = 0.0;                  ///< at which soil is looked at [m]
};

/// The ground that stands, by columns.
struct StandingGround {
  Columns columns;
  Real level = 0.0;           ///< [m]
  std::vector<Real> heights;  ///< of the surface in the middle of a column [m]; minus infinity: no ground
  std::vector<Real> sheared;  ///< at the level: share of the soil that is not intact [-]; 0 where there is none
};

/// Ground that rests on the boundary of the mesh, or hangs together with such by the sides of cells: soil in the air
/// does not count. In a cell the surface lies as high as the volume of its ground fills it.
StandingGround look_at_ground(const Mesh<2>& mesh, const PointBlocks<2>& points, const GroundQuestion& question);

/// Columns first ... last - 1.
struct ColumnRange {
  Index first = 0, last = 0;
};

/// The columns that hold the water back: all, but for high land behind lower land. That is ground at an end of the
/// section that stands at the level or above, where lower ground parts it from other ground that does. It is never at
/// the river's end, where that is known: what stands there holds the water.
ColumnRange columns_of_barrier(const StandingGround& ground, std::optional<Facing> river);

/// What remains to hold the water.
struct Barrier {
  Real height = 0.0;        ///< of the highest ground [m]; minus infinity: there is none
  Real width = 0.0;         ///< of the widest stretch of ground at the level [m]
  Real intact_width = 0.0;  ///< of the intact soil in that stretch [m]
};

Barrier find_barrier(const StandingGround& ground, ColumnRange range);

/// Left end of the top of a profile that fits inside the ground [m]: level at `ground.level` over the width, from where
/// it falls by 1:slope to both sides. The first one from the left; none: no such profile fits.
std::optional<Real> place_of_profile(const StandingGround& ground, ColumnRange range, Real width, Real slope);

}  // namespace terp
