// The soil of a stage along a vertical line: which layer lies where, after excavations, and where the ground is.
// Not for: stresses (section.hpp).
#pragma once

#include "import/dstability/project.hpp"
#include "model/bodies/polygon.hpp"

#include <vector>

namespace terp {

/// Limits of all outlines [m]; of no layer its low corner is above its high one.
BoundingBox box_around(const std::vector<StixLayer>& layers);

/// A piece of the vertical line within one layer.
struct SoilBand {
  Real top, bottom;   ///< [m]
  std::size_t layer;  ///< number in StixStage::layers
};

/// From the top down. Of layers inside each other the smaller one holds; what an excavation removes is not there.
/// Beyond both ends of the section it is as at the end.
std::vector<SoilBand> soil_bands(const StixStage& stage, Real x);

/// The band at z: above the ground null; in a gap between outlines the nearest one.
const SoilBand* band_at(const std::vector<SoilBand>& bands, Real z);

}  // namespace terp
