// How much soil has moved away from where it began, how much of it is intact, and how far it came. Definitions: docs/formats.md.
#pragma once

#include "points/point_blocks.hpp"

#include <span>

namespace terp {

/// Volume of the points that lie farther than `distance` [m] from their first places [m^2]. x_initial: by id, shape [n_points, 2] [m].
Real moved_volume(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance);

/// Plastic strain below which soil counts as intact [-]: a hundredth. Strength that softens with eta = 50 has then lost two fifths of
/// what it can lose; a shear band strains a hundred times as much.
inline constexpr Real intact_strain = 0.01;

/// Share of the volume that moved whose eps_eq_p is below `intact_strain` [-]; NaN if no such soil moved. strain_rows: by material the
/// state variable that is eps_eq_p, -1: none, and soil of that material is left out.
Real intact_share(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance, std::span<const int> strain_rows);

/// Smallest x of the points that came farther than `distance` to the left, and largest of those that came to the right [m]; NaN: none did.
std::array<Real, 2> reach(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance);

}  // namespace terp
