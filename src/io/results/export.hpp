// Frames of a run as CSV, for spreadsheets and scripts without HDF5.
#pragma once

#include "io/results/frames.hpp"

#include <string>
#include <vector>

namespace terp {

struct ExportOptions {
  std::vector<std::string> fields;  ///< empty: all
  std::string frames;               ///< "0,5,10:20,last"; empty: all
  std::string folder;               ///< made if it is not there
};

/// Frames of "0,5,10:20,last", each once and ascending; a range ends with its second number. Throws FileError that says
/// what is allowed.
std::vector<std::size_t> parse_frames(const std::string& text, std::size_t n_frames);

/// Writes frame_00000.csv ..., a row for each point of which there is soil, and frames.csv with file, time and step.
/// Frames that turn out to be damaged are left out, and named by `frames.warnings`. Returns the paths.
std::vector<std::string> export_frames(Frames& frames, const ExportOptions& options);

}  // namespace terp
