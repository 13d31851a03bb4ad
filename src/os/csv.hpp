// Rows of a CSV table: cells apart by commas; one in double quotes may hold commas, and quotes that stand twice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// A text as a cell: in quotes if it holds a comma or a quote. A line break becomes "; ".
std::string csv_cell(std::string_view text);

/// The same for a text that others wrote: a spreadsheet takes what begins with = + - or @ and is no number for a
/// formula, so such a text gets an apostrophe before it.
std::string plain_csv_cell(std::string_view text);

/// The cells of a line, without their quotes.
std::vector<std::string> csv_cells(std::string_view line, char separator = ',');

}  // namespace terp
