// What the case of a study says against changes, and what they say against each other, for messages of the study
// file.
#pragma once

#include "batch/study.hpp"

#include <string>
#include <vector>

namespace terp {

/// Empty: it takes them. changes: KEY=VALUE, `set` included.
std::string refusal_of(const Study& study, const std::vector<std::string>& changes);

/// `set`, and then these.
std::vector<std::string> changes_with(const Study& study, const std::vector<std::string>& changes);

/// Adds a problem for each two keys of which the later one would undo the other: the same place under two names, a part
/// and its whole, a parameter and its ratio to another (su_residual and sensitivity).
void refuse_overlaps(const Study& study, std::vector<Problem>& problems);

}  // namespace terp
