// The report page: a built template with the data put in its place (docs/report_format.md).
#pragma once

#include "page/payload.hpp"

#include <string>
#include <string_view>

namespace terp {

/// Stands once in the template, where the data go.
inline constexpr std::string_view data_marker = "<!--terp-data-->";

/// The template that was built into the program; a bare page with the marker where the page was not built.
std::string_view page_template();

/// False if the program was built without the page.
bool has_page();

/// The whole HTML file. Throws std::invalid_argument if the template does not have the marker exactly once.
std::string make_page(std::string_view page_template, const Payload& payload);

}  // namespace terp
