// Problems as the user sees them: file, line and column, the line itself with the place underlined, what to do.
#pragma once

#include "math/errors.hpp"
#include "io/case/document.hpp"

#include <string>
#include <vector>

namespace terp {

/// Most problems that are shown at once.
inline constexpr std::size_t max_shown = 10;

/// In the order of the file, at most max_shown, with the count at the end.
std::string render_errors(const std::vector<Problem>& problems, const Document& document);

/// The same for warnings, without the count; empty if there are none. run: folder that each names, so that many runs
/// may share one log; may be empty.
std::string render_warnings(
    const std::vector<Problem>& warnings, const Document& document, const std::string& run = "");

/// One message at a place of a text: "error: FILE:3:7: WHAT", the line, the detail.
std::string render_at(const std::string& path, const std::string& text, Place place, const Problem& problem);

}  // namespace terp
