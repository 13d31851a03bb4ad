// convergence.html: a study of cell sizes as one page that opens without a network and can be printed.
#pragma once

#include "io/results/mesh_study.hpp"
#include "page/payload.hpp"

#include <string>

namespace terp {

/// convergence.json with the ledgers of the runs. written: time, UTC, ISO 8601.
Payload convergence_payload(const MeshStudy& study, const std::string& written);

}  // namespace terp
