// How long the law of a library takes.
#pragma once

#include "mpm/points/soil_material.hpp"

namespace terp {

struct LawCost {
  double seconds = 0.0;  ///< of one point in one step, by one thread
  std::string fault;     ///< of the law in the trial, in words; empty: none
};

/// Calls the law again and again for points of a block as they are, with a small shear strain, on copies that each call
/// has anew. cell_size: of the cell of the block [m]. dt: length of a step [s].
LawCost time_law(const SoilMaterial& material, const PointBlock<2>& block, Real cell_size, Real dt);

}  // namespace terp
