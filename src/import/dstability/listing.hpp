// What a D-Stability file holds, as a table for an engineer and as JSON for a program.
#pragma once

#include "import/dstability/project.hpp"

#include <functional>

namespace terp {

/// How a stored result stands to what Terp computes of the file: "fits", "other section", "no slices", ...
using StixVerdict = std::function<std::string(std::size_t scenario, std::size_t calculation)>;

/// Scenarios with stages and calculations, soils with strengths, what is left out. Weights in kN/m^3, strengths in kPa.
std::string listing_of(const StixProject& project, const StixVerdict& verdict);

/// The same as JSON, in SI units.
std::string listing_json(const StixProject& project, const StixVerdict& verdict);

/// Word of a strength model, as the table writes it.
const char* word_of(StixStrengthModel model);

}  // namespace terp
