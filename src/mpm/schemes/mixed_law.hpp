// What MPM-Mixed does at Gauss points, whichever points it has its sums from.
#pragma once

#include "mpm/step/gauss_passes.hpp"

namespace terp {

/// Of eight cells [J per m].
struct GaussWork {
  Pack plastic{0.0}, plastic_beside{0.0};  ///< with the weights of the force; by how much more with the volumes
  Pack power{0.0};                         ///< of the stress at the start on the strain, with the volumes of the points
};

/// Rows of the law from their sums over sub-cells.
void take_means_of_rows(LayerNow& now);
/// Runs the law on the Gauss points of a layer, Step 3. Leaves its plastic work there.
GaussWork update_gauss_points(LayerNow& now);

/// Over patches of cells (mixed_patches.cpp).
extern const Kernel mixed_patches[5];

}  // namespace terp
