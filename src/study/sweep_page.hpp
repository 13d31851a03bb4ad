// The section of the page of a sweep. Not for: its table, which is that of all studies (study_page).
#pragma once

#include "study/store.hpp"

#include <string>

namespace terp {

/// Events and outcomes against the first key that takes numbers; empty if there is none.
std::string sweep_section(const Study& study, const Realisations& rows, Index n);

}  // namespace terp
