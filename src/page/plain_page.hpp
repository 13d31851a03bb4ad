// A page of text, tables and charts in one HTML file, without the viewer of runs: of studies of many runs.
#pragma once

#include "page/line_chart.hpp"

#include <string>
#include <vector>

namespace terp {

struct PlainPage {
  std::string title, name, subtitle;  ///< of its head; name: of the window
  std::string body;                   ///< HTML
  std::string footer;
  std::string language = "en";  ///< of its text, ISO 639-1
  std::string style = {};       ///< CSS rules that this page adds to the common ones
};
std::string plain_page(const PlainPage& page);

/// <tag attributes>text</tag>, with the text escaped.
std::string html_cell(const char* tag, const std::string& text, const char* attributes = "");

/// A list; empty if there are no items. name: attributes.
std::string html_list(const std::vector<std::string>& items, const char* name);

/// A table that scrolls by itself. rows: <tr>.
std::string html_table(const std::vector<std::string>& titles, const std::string& rows);

/// The charts that have a point, side by side; empty if there are none.
std::string html_figures(const std::vector<LineChart>& charts);

}  // namespace terp
