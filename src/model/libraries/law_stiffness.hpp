// What a law of a library answers to small strains, to be compared with the moduli that the case gives.
#pragma once

#include "mpm/points/soil_material.hpp"

namespace terp {

/// Of one point, each component strained by itself there and back: of the two answers the stiffer one.
struct LawStiffness {
  Real normal = 0.0;         ///< the largest of d sigma_xx/d eps_xx, yy and zz: K + 4G/3 of isotropic soil [Pa]
  Real shear = 0.0;          ///< d sigma_xy/d(2 eps_xy): G [Pa]
  Real shear_of_axes = 0.0;  ///< (xxxx + yyyy - xxyy - yyxx)/4: G where the law is isotropic [Pa]
  bool is_elastic = false;   ///< there and back the answers are the same: the point does not yield
  bool failed = false;       ///< the law has a fault
};

/// cell_size: of the cell of the block [m]. dt: length of a step [s]. The law of the material is called 8 times.
LawStiffness measure_stiffness(
    const SoilMaterial& material, const PointBlock<2>& block, Index lane, Real cell_size, Real dt);

}  // namespace terp
