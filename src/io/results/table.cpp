// Only whole lines are read, since a run may still be writing the last one. A file with names of points is read as if
// all its columns were numbers. The column of names then has no meaning, and is taken out when the rows are grouped
// by point.

#include "io/results/table.hpp"

#include "os/csv.hpp"
#include "math/errors.hpp"
#include "math/nan.hpp"
#include "math/number_from.hpp"
#include "run/measure/followers.hpp"
#include "io/files/files.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace terp {
namespace {

/// The cells of all whole lines, the header first. Throws FileError if a line has another number of cells than the
/// header.
std::vector<std::vector<std::string>> read_cells(const std::string& path)
{
  const std::string text = read_file(path);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    rows.push_back(csv_cells(std::string_view(text).substr(begin, end - begin)));
    if (rows.back().size() != rows.front().size())
      throw FileError(fmt::format("cannot read {}: line {} has {} columns, the header {}", path, rows.size(),
          rows.back().size(), rows.front().size()));
  }
  if (rows.empty()) throw FileError(fmt::format("cannot read {}: it has no header", path));
  return rows;
}

void add_row(Table& table, const std::vector<std::string>& cells)
{
  for (std::size_t c = 0; c < cells.size(); ++c) table.columns[c].push_back(number_from<Real>(cells[c]).value_or(nan));
}

Table empty_table(const std::vector<std::string>& names)
{
  return {names, std::vector<std::vector<Real>>(names.size())};
}

}  // namespace

const std::vector<Real>* Table::find(std::string_view name) const
{
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

Table read_number_table(const std::string& path)
{
  const auto rows = read_cells(path);
  Table table = empty_table(rows[0]);
  for (std::size_t r = 1; r < rows.size(); ++r) add_row(table, rows[r]);
  return table;
}

std::vector<PointTable> read_history(const std::string& path, std::string_view name_column)
{
  const auto rows = read_cells(path);
  const auto point = static_cast<std::size_t>(std::ranges::find(rows[0], name_column) - rows[0].begin());
  if (point == rows[0].size()) throw FileError(fmt::format("cannot read {}: it has no column `{}`", path, name_column));
  std::vector<PointTable> tables;
  std::map<std::string, std::size_t> places;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const auto [place, is_new] = places.try_emplace(rows[r][point], tables.size());
    if (is_new) tables.push_back({place->first, empty_table(rows[0])});
    add_row(tables[place->second].table, rows[r]);
  }
  for (auto& [name, table] : tables) {  // the name is no number
    table.names.erase(table.names.begin() + static_cast<std::ptrdiff_t>(point));
    table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(point));
  }
  return tables;
}

QuantityInfo describe_column(std::string_view name)
{
  for (const auto& table : all_tables())
    for (const QuantityInfo& column : table->columns)
      if (column.name == name) return column;
  return {.name = name, .unit = "-", .label = name, .meaning = {}};
}

}  // namespace terp
