// Reads a D-Stability file (.stix) of either data model, or says exactly what is wrong with it. docs/dstability.md.
// Path: zip_members -> json_tree -> json_cursor -> read_soils, read_parts, read_results -> here: ids become contents.
// Not for: stresses and strengths (section.hpp).
#pragma once

#include "import/dstability/project.hpp"
#include "import/dstability/zip_members.hpp"

namespace terp {

/// Throws InputError with up to ten faults, FileError if the file cannot be read. What was not understood, or has no
/// place in a run of Terp, is in StixProject::remarks.
StixProject read_stix(const std::string& path);

/// The same from memory; `path` is what messages call it.
StixProject read_stix_bytes(std::string bytes, const std::string& path, ZipLimits limits = {});

}  // namespace terp
