// The data of the pages of a study: results.json, with the realisations and what becomes of P as they grow in number.
#pragma once

#include "batch/estimates.hpp"
#include "page/payload.hpp"

#include <string>

namespace terp {

/// written: when, in UTC.
Payload study_payload(const Study& study, const Realisations& rows, const std::string& written);

/// The page of `terp study sample`: what would be drawn, before a long run.
Payload samples_payload(const Study& study, Index n, const std::string& written);

}  // namespace terp
