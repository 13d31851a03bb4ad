#include "page/page.hpp"

// Made an object by cmake/page.cmake. One line without the marker if there is none.
extern "C" {
extern const char _binary_page_html_start[];
extern const char _binary_page_html_end[];
}

namespace terp {
namespace {

std::string_view built_page()
{
  return {_binary_page_html_start, static_cast<std::size_t>(_binary_page_html_end - _binary_page_html_start)};
}

constexpr std::string_view bare_page = R"(<!doctype html>
<meta charset="utf-8"><title>Terp report</title>
<p>This Terp was built without its report page: the data are in this file, but nothing shows them.
Install Node.js, build Terp again (make build) and write the page anew.</p>
<!--terp-data-->
)";

}  // namespace

std::string_view page_template() { return has_page() ? built_page() : bare_page; }

bool has_page() { return built_page().find(data_marker) != std::string_view::npos; }

}  // namespace terp
