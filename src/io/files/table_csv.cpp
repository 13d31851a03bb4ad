// A run that continues drops the rows after its checkpoint and appends. So only whole rows count, and a header that was
// cut off by a kill is as no file. The checksum runs over all bytes, those of earlier processes included.

#include "io/files/table_csv.hpp"
#include "math/number_from.hpp"

#include "os/csv.hpp"
#include "math/errors.hpp"

#include <cmath>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

namespace terp {
namespace {

void add_number(std::string& line, Real value)
{
  if (std::isnan(value))
    line += "nan";  // never "-nan"
  else
    fmt::format_to(std::back_inserter(line), "{}", value);
}

Real time_of(std::string_view row)
{
  Real time = std::nan("");
  from_chars(row.data(), row.data() + row.size(), time);
  return time;
}

struct Part {
  std::size_t length;  ///< in bytes, from the start of the table
  std::int64_t n_rows = 0;
};

/// Up to the end of the last whole row with a time of at most `time`.
Part part_until(std::string_view table, Real time)
{
  Part part{table.find('\n') + 1};
  while (part.length < table.size()) {
    const std::size_t line_end = table.find('\n', part.length);
    if (line_end == std::string_view::npos || !(time_of(table.substr(part.length, line_end - part.length)) <= time))
      break;
    part.length = line_end + 1;
    ++part.n_rows;
  }
  return part;
}

/// The text of a table, which must have this header; nothing if the run was killed while it wrote that.
std::string read_table(const std::string& path, std::string_view header)
{
  std::string table = read_file(path);
  const std::string first_line = std::string(header) + '\n';
  if (table.starts_with(first_line)) return table;
  if (first_line.starts_with(table)) return "";
  throw FileError(fmt::format("cannot continue {}: its columns are not those of terp {}", path, TERP_VERSION));
}

}  // namespace

std::string header_of(const RunTable& table)
{
  std::string line;
  for (const QuantityInfo& column : table.columns) line += (line.empty() ? "" : ",") + std::string(column.name);
  return line;
}

std::string csv_lines(const std::vector<TableRow>& rows)
{
  std::string lines;
  for (const TableRow& row : rows) {
    std::size_t k = 0;
    for (const QuantityInfo& column : row.table->columns) {
      if (column.is_text)
        lines += csv_cell(row.text);
      else
        add_number(lines, row.values[k++]);
      lines += ',';
    }
    lines.back() = '\n';
  }
  return lines;
}

std::string table_line(std::string_view file, const std::string& checksum)
{
  return fmt::format("{} = {}\n", file, checksum);
}

TablePart read_part_until(const std::string& path, std::string_view header, Real time)
{
  if (!std::filesystem::exists(path)) return {};
  const std::string table = read_table(path, header);
  const Part part = part_until(table, time);
  return {part.n_rows, digits_of(std::string_view(table).substr(0, part.length))};
}

void drop_rows_after(const std::string& path, std::string_view header, Real time)
{
  if (!std::filesystem::exists(path)) return;
  const std::string table = read_table(path, header);
  const std::size_t length = part_until(table, time).length;
  if (length < std::filesystem::file_size(path)) write_file_atomically(path, std::string_view(table).substr(0, length));
}

TableFile::TableFile(const std::string& path, std::string_view header) : file_(path)
{
  const std::string text = read_file(path);
  checksum_.add(text);
  n_bytes_ = std::ssize(text);
  if (std::filesystem::is_empty(path)) append(std::string(header) + '\n');
}

void TableFile::append(std::string_view lines)
{
  file_.append(lines);
  checksum_.add(lines);
  n_bytes_ += std::ssize(lines);
}

}  // namespace terp
