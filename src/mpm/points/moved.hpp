// How much soil has moved away from where it began, how much of it is intact, and how far it came. Definitions:
// docs/formats.md.
#pragma once

#include "mpm/points/ground.hpp"

#include <limits>
#include <span>

namespace terp {

/// Soil that lies farther than some distance from its first place.
struct MovedSoil {
  Real volume = 0.0;  ///< [m^2]
  Real reach_left =
      std::numeric_limits<Real>::quiet_NaN();  ///< smallest x of what came to the left [m]; NaN: nothing did
  Real reach_right =
      std::numeric_limits<Real>::quiet_NaN();  ///< largest x of what came to the right [m]; NaN: nothing did
};

/// How far a point has come from its first place [m], or had come before displacement was counted anew, if that is
/// more. moved_before: by id, shape [n_points] [m]; empty: it never was.
Real farthest_way(
    const PointBlock<2>& block, Index lane, std::span<const Real> x_initial, std::span<const Real> moved_before);

/// What two parts of the soil moved.
MovedSoil join(const MovedSoil& a, const MovedSoil& b);

/// The ground that lies farther than `distance` [m] from its first place.
MovedSoil find_moved(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance, Ground ground = {});

/// Plastic strain below which soil counts as intact [-]: a hundredth. Strength that softens with eta = 50 has then lost
/// two fifths of what it can lose; a shear band strains a hundred times as much.
inline constexpr Real intact_strain = 0.01;

/// Share of the volume that moved whose eps_eq_p is below `intact_strain` [-]; NaN if no such soil moved. strain_rows:
/// by material the row of the plastic strain, -1: none, and what is of that material is left out.
Real intact_share(
    const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance, std::span<const int> strain_rows);

}  // namespace terp
