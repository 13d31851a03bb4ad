// stability.json and stability.txt: a factor of safety with its bracket, and the trials it rests on (docs/formats.md).
#pragma once

#include "io/files/run_folder.hpp"
#include "run/stability/factor_of_safety.hpp"

#include <string>

namespace terp {

std::string stability_json(const StabilityResult& result, const std::string& scheme, const CaseText& case_text);
/// For a person: the factor, its bracket, the criterion, a line per trial.
std::string stability_text(const StabilityResult& result, const std::string& scheme);

/// Writes both into a folder, which is made if need be. Throws FileError.
void write_stability(
    const std::string& folder, const StabilityResult& result, const std::string& scheme, const CaseText& case_text);

}  // namespace terp
