// Parameters of laws that points have values of their own of, so that Python can set them.
#pragma once

#include "io/case/case_file.hpp"

#include <map>
#include <string>
#include <vector>

namespace terp {

/// Changes of a case, value by key, that leave its numbers as they are, but let points have values of their own of
/// these parameters. Throws CaseError if no law of the case lets one vary, with those that may.
std::map<std::string, std::string> changes_to_vary(const CaseFile& file, const std::vector<std::string>& names);

}  // namespace terp
