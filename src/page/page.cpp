#include "page/page.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace terp {

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
