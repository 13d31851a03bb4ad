#include "page/page.hpp"

#include <stdexcept>

#include <fmt/format.h>

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

std::string make_page(std::string_view page, const Payload& payload)
{
  const std::size_t marker = page.find(data_marker);
  if (marker == std::string_view::npos || page.find(data_marker, marker + 1) != std::string_view::npos)
    throw std::invalid_argument(fmt::format("the page must hold {} exactly once", data_marker));
  std::string html(page.substr(0, marker));
  html += "<script id=\"terp-report\" type=\"application/json\">" + payload.json + "</script>\n";
  for (std::size_t k = 0; k < payload.chunks.size(); ++k)
    html +=
        fmt::format("<script type=\"application/octet-stream\" data-chunk=\"{}\">{}</script>\n", k, payload.chunks[k]);
  html += page.substr(marker + data_marker.size());
  return html;
}

}  // namespace terp
