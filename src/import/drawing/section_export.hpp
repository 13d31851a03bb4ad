// The section that a run leaves, for CAD and spreadsheets: ground at the start and the end, outlines of materials.
#pragma once

#include "io/results/run_results.hpp"

#include <string>

namespace terp {

/// The soil of a frame, point by point: places [m], volumes [m^2], numbers of materials.
struct SoilPoints {
  std::vector<Vec<2>> places;
  std::vector<Real> volumes;
  std::vector<int> materials;
};
SoilPoints soil_points(const Frames& frames, std::size_t frame);

struct SectionExport {
  std::string dxf;  ///< layers ground_start, ground_end, and one for each material: its outlines at the end
  std::vector<std::array<Real, 3>> profile;  ///< x, ground at the start and at the end [m]; NaN where no soil was
  Real start = 0.0, end = 0.0;               ///< times of the two [s]

  std::string profile_csv() const;
};

/// Throws FileError if the first or the last frame of the run cannot be read, or no soil is left in it.
SectionExport export_section(const RunResults& run);

/// The ground alone: x, at the start and at the end [m].
std::vector<std::array<Real, 3>> profile_of(const RunResults& run);

}  // namespace terp
