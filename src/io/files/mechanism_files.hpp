// The mechanism at failure as files: a frame of the points, and a picture (docs/formats.md).
// Not for: what it is (run/stability/mechanism).
#pragma once

#include "io/files/files.hpp"
#include "model/case/case.hpp"
#include "run/stability/factor_of_safety.hpp"

#include <string>
#include <string_view>

namespace terp {

inline constexpr std::string_view mechanism_folder = "mechanism", mechanism_picture = "mechanism.svg";

/// SVG of the section with the shear strain, the motion and the slip surface of what failed, else of what crept. quiet:
/// the case that the trials solved.
std::string draw_mechanism(const Case& quiet, const StabilityResult& result);

/// Writes the picture into a folder, and frame and mesh into a folder in it. run: 16 digits that depend on the case.
/// Nothing without a mechanism. Throws FileError.
void write_mechanism(
    const std::string& folder, const Case& quiet, const StabilityResult& result, const std::string& run);

}  // namespace terp
