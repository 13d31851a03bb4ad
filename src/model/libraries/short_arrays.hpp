// Whether the law of a library reads numbers that it was not given, as where the case forgot a parameter.
#pragma once

#include "mpm/points/soil_material.hpp"

#include <string_view>

namespace terp {

/// Strains points of a block in shear, compression and extension, again and again with other numbers behind the arrays
/// of the law. Returns the key of the array whose end the answer depends on: "parameters" or "state". Empty: of none,
/// or the answer depends on something else, as on how often the law was called. values: moduli of the case.
/// cell_size: of the cell of the block [m]. dt: length of a step [s].
std::string_view find_short_array(
    const SoilMaterial& material, std::span<const Real> values, const PointBlock<2>& block, Real cell_size, Real dt);

}  // namespace terp
