// The section that a run leaves, for CAD and spreadsheets: ground at the start and the end, outlines of materials.
#pragma once

#include "io/results/run_results.hpp"
#include "model/ground/ground_section.hpp"

#include <string>

namespace terp {

SoilPoints soil_points(const Frames& frames, std::size_t frame);

/// The section at the two ends of a run.
struct EndsOfRun {
  Case description;
  Frames frames;
  SoilPoints end;
  std::vector<Vec<2>> ground_start, ground_end;  ///< in the middle of columns, left to right [m]
};
/// Throws FileError if the mesh, the first or the last frame cannot be read, or no soil is left in the last.
EndsOfRun ends_of(const RunResults& run);

struct SectionExport {
  std::string dxf;  ///< layers ground_start, ground_end, and one for each material: its outlines at the end
  std::vector<std::array<Real, 3>> profile;  ///< x, ground at the start and at the end [m]; NaN where no soil was
  Real start = 0.0, end = 0.0;               ///< times of the two [s]

  std::string profile_csv() const;
};

/// Throws as ends_of does.
SectionExport export_section(const RunResults& run);

/// The ground alone: x, at the start and at the end [m].
std::vector<std::array<Real, 3>> profile_of(const RunResults& run);

}  // namespace terp
