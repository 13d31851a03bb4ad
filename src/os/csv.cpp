#include "os/csv.hpp"

#include <cstdlib>

namespace terp {

std::string csv_cell(std::string_view text)
{
  std::string cell;
  for (const char c : text) {
    if (c == '"') cell += '"';
    if (c == '\n')
      cell += "; ";
    else if (c != '\r')
      cell += c;
  }
  return cell.find_first_of(",\"") == std::string::npos ? cell : '"' + cell + '"';
}

std::string plain_csv_cell(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || std::string_view("=+-@").find(text[first]) == std::string_view::npos)
    return csv_cell(text);
  char* end = nullptr;
  const std::string number(text);
  std::strtod(number.c_str(), &end);
  return csv_cell(*end == '\0' ? number : "'" + number);
}

std::vector<std::string> csv_cells(std::string_view line, char separator)
{
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"')
      cells.back() += line[++k];
    else if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

}  // namespace terp
