// The ground and the outlines of materials that points of a run fill, on square boxes of about a cell: what a colleague
// with CAD gets of a result. Not for: drawn sections (clean_regions.hpp); what a run measures (mpm/points/surface).
#pragma once

#include "import/drawing/clean_regions.hpp"

namespace terp {

struct PointSection {
  Real box = 0.0;                    ///< side of a box: three points of typical size [m]
  std::vector<Vec<2>> ground;        ///< top of the soil in the middle of what each column holds, left to right [m]
  std::vector<CleanRegion> regions;  ///< `drawn`: number of the material

  /// Level of the ground [m]; NaN where no soil is.
  Real ground_at(Real x) const;
};

struct OutlineOptions {
  /// Within which outlines are straightened [m]; 0: three quarters of the boxes that they follow.
  Real tolerance = 0.0;
  /// They follow ninths of boxes, each of the material of its point, and lie nowhere below `ground`: for a caller that
  /// cuts them there.
  bool reaches_above = false;
};

/// places [m], volumes [m^2] and materials of the points, shape [n_points]. In a box of the top the ground is as high
/// as the points fill it, at an end of the soil over the width that they have there; boxes filled by less than a
/// twentieth do not count. A box has the material with most volume in it, if points fill half of it. Outlines are
/// straightened.
PointSection section_of_points(std::span<const Vec<2>> places, std::span<const Real> volumes,
    std::span<const int> materials, const OutlineOptions& options = {});

}  // namespace terp
