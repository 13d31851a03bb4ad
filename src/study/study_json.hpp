// What a study found, for other programs. Keys: docs/formats.md.
#pragma once

#include "study/estimates.hpp"

#include <string>

namespace terp {

/// results.json: null where nothing is known.
std::string study_json(const Study& study, const Realisations& rows);

}  // namespace terp
