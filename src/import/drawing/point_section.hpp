// The outlines of materials that points of a run fill, on square boxes of about a cell: what a colleague with CAD gets
// of a result. Not for: drawn sections (clean_regions.hpp); the ground (model/ground/ground_section.hpp).
#pragma once

#include "import/drawing/clean_regions.hpp"

namespace terp {

struct PointRegions {
  Real box = 0.0;                    ///< side of a box: three points of typical size [m]
  std::vector<CleanRegion> regions;  ///< `drawn`: number of the material
};

struct OutlineOptions {
  /// Within which outlines are straightened [m]; 0: three quarters of the boxes that they follow.
  Real tolerance = 0.0;
  /// They follow ninths of boxes, each of the material of its point, and reach a box above the highest ones: for a
  /// caller that cuts them at the ground.
  bool reaches_above = false;
};

/// places [m], volumes [m^2] and materials of the points, shape [n_points]. A box has the material with most volume in
/// it, if points fill half of it. Outlines are straightened.
PointRegions regions_of_points(std::span<const Vec<2>> places, std::span<const Real> volumes,
    std::span<const int> materials, const OutlineOptions& options = {});

}  // namespace terp
