// The section [fragility] of a study file: a load, its levels, and how the case follows it.
#pragma once

#include "input/values.hpp"
#include "study/study_file.hpp"

#include <optional>

namespace terp {

/// None: the file has no such section. Adds problems.
std::optional<FragilityLoad> read_fragility(const Node& root, Findings& findings);

/// Takes the distribution of the load out of the section: it has no say in what realisations give.
void drop_distribution(Node& section);

}  // namespace terp
