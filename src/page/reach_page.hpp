// index.html of a reach: one row per section with its verdict and a link to its report page. Opens without a network.
#pragma once

#include "io/results/reach.hpp"

#include <string>

namespace terp {

/// language: one of report_languages. written: time, UTC, ISO 8601.
std::string reach_page(
    const std::vector<ReachSection>& sections, const std::string& language, const std::string& written);

/// The ground of a section before and after, and the water, as a small picture (SVG); empty: nothing is known of it.
std::string reach_picture(const ReachSection& section);

}  // namespace terp
