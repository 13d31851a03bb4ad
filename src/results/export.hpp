// Frames of a run in formats that other tools read: vtu with pvd, csv, npz.
#pragma once

#include "results/frames.hpp"

#include <string>
#include <vector>

namespace terp {

enum class ExportFormat { vtu, csv, npz };

struct ExportOptions {
  ExportFormat format = ExportFormat::vtu;
  std::vector<std::string> fields;  ///< empty: all
  std::string frames;               ///< "0,5,10:20,last"; empty: all
  std::string folder;               ///< made if it is not there
};

/// Frames of "0,5,10:20,last", each once and ascending; a range ends with its second number. Throws FileError that says
/// what is allowed.
std::vector<std::size_t> parse_frames(const std::string& text, std::size_t n_frames);

/// Writes frame_00000.<format> ..., and for vtu frames.pvd, for csv and npz frames.csv with file, time and step.
/// Returns the paths.
std::vector<std::string> export_frames(const Frames& frames, const ExportOptions& options);

}  // namespace terp
