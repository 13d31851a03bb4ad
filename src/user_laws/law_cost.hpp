// How long the law of a library takes.
#pragma once

#include "materials/soil_material.hpp"

namespace terp {

struct LawCost {
  double seconds = 0.0;  ///< of one point in one step, by one thread
  std::string fault;     ///< of the law, in words; empty: none
};

/// Calls the law again and again for points of a block as they are, with a small shear strain, on copies. dt: length of
/// a step [s].
LawCost time_law(const SoilMaterial& material, const PointBlock<2>& block, Real dt);

}  // namespace terp
