// What the case of a study says against changes, for a message of the study file.
#pragma once

#include "study/study.hpp"

#include <string>
#include <vector>

namespace terp {

/// Empty: it takes them. changes: KEY=VALUE, `set` included.
std::string refusal_of(const Study& study, const std::vector<std::string>& changes);

/// `set`, and then one change more, or several.
std::vector<std::string> changes_with(const Study& study, const std::string& change);
std::vector<std::string> changes_with(const Study& study, const std::vector<std::string>& changes);

}  // namespace terp
