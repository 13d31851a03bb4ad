// convergence.html: a study of cell sizes as one page that opens without a network and can be printed.
#pragma once

#include "io/results/mesh_study.hpp"

#include <string>

namespace terp {

/// The whole HTML file. written: time, UTC, ISO 8601.
std::string study_page(const MeshStudy& study, const std::string& written);

}  // namespace terp
