// The section that a run leaves, as a stage of the D-Stability file that it was imported from.
// Not for: the members of the file (stix_stage.hpp); CAD and tables (drawing/section_export.hpp).
#pragma once

#include "io/results/run_results.hpp"

#include <string>

namespace terp {

struct StixExportOptions {
  std::string original;                 ///< path of the .stix file
  std::size_t scenario = 0, stage = 0;  ///< numbers from 0: which the new stage follows
  Real tolerance = 0.0;                 ///< within which outlines are straightened [m]; 0: a good half of a cell
};

struct StixExport {
  std::string bytes;               ///< of the file
  Real time = 0.0;                 ///< of the section [s]
  std::size_t n_layers = 0;        ///< of the new stage
  std::vector<std::string> notes;  ///< what is not as in the run
};

/// Throws FileError if the last frame cannot be read, InputError if a material is of no soil of the file, or an outline
/// is none that a layer can have.
StixExport export_stix(const RunResults& run, const StixExportOptions& options);

}  // namespace terp
