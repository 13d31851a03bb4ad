// Water in soil that slides: what was wet stays wet, and its pressures are those of a flow through the wet soil as it
// lies. Not for: which soil is wet (model/water/carried_water), nor flow with a free surface (free_surface.hpp).
#pragma once

#include "model/seepage/flow_soil.hpp"

#include <functional>
#include <span>
#include <vector>

namespace terp {

/// The wet part of a material point.
struct WetPoint {
  Vec<2> x;     ///< [m]
  Index cell;   ///< that holds it
  Real volume;  ///< that is wet [m^2]
  Permeability k;
};

/// What lies over a place: by x [m]; minus infinity where there is none.
struct AboveSoil {
  std::function<Real(Real)> ground, free_water;
};

/// Heads at the nodes [m]; not a number where the flow has no equation. sides: places with a head at the ends and the
/// base. The wet soil ends where half of a cell is filled; its surface has p = 0 within the soil, is a seepage face
/// where it is bare, and has the level of free water over it.
std::vector<Real> frozen_heads(
    const Mesh<2>& mesh, std::span<const WetPoint> points, const AboveSoil& above, std::vector<SurfacePlace> sides);

}  // namespace terp
