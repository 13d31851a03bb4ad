// Only the header stops at once: without the places of the columns no row can be read. A decimal comma shows as about
// twice as many cells as columns.

#include "model/bodies/csv_rows.hpp"

#include "math/closest.hpp"
#include "os/csv.hpp"
#include "math/utf8.hpp"
#include "math/number_from.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace terp {
namespace {

constexpr std::int64_t most_shown = 10;
constexpr const char* decimal_point = "; numbers have a decimal point, no comma";

std::vector<std::string> split(std::string_view line)
{
  std::vector<std::string> cells = csv_cells(line);
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

/// Number of the cell of each column in a line.
using Places = std::vector<std::size_t>;

/// What stands between the names instead of commas, in words; empty if commas do, or if there is one name.
std::string other_separator(std::string_view line)
{
  if (line.find(',') != std::string_view::npos) return "";
  if (line.find(';') != std::string_view::npos) return "semicolons";
  if (line.find('\t') != std::string_view::npos) return "tabs";
  return line.find(' ') != std::string_view::npos ? "blanks" : "";
}

Places read_header(std::string_view line, Index number, std::span<const std::string> columns, CsvFaults& faults)
{
  if (const std::string other = other_separator(line); !other.empty()) {
    faults.add(number, fmt::format("the values are separated by {}; Terp reads commas, and a decimal point in numbers. "
                                   "In a spreadsheet: save as CSV with commas, language English",
                           other));
    return {};
  }
  const auto names = split(line);
  if (std::ranges::all_of(names, [](std::string_view name) { return number_in_csv(name).has_value(); })) {
    faults.add(number, fmt::format("the first row holds numbers; above it stand the names of the columns: {}",
                           fmt::join(columns, ",")));
    return {};
  }
  for (const std::string& name : names) {
    if (std::ranges::find(columns, name) != columns.end()) continue;
    const std::string meant = closest(name, {columns.begin(), columns.end()});
    faults.add(
        number, fmt::format("unknown column `{}`{}", name, meant.empty() ? "" : "; did you mean `" + meant + "`?"));
  }
  Places places;
  for (const std::string& column : columns) {
    const auto n = std::ranges::count(names, column);
    if (n == 0) faults.add(number, fmt::format("no column `{}`", column));
    if (n > 1) faults.add(number, fmt::format("column `{}` is there {} times", column, n));
    places.push_back(static_cast<std::size_t>(std::ranges::find(names, column) - names.begin()));
  }
  return places;
}

bool says_nothing(std::string_view line) { return line.empty() || line.front() == '#'; }

}  // namespace

CsvFaults::CsvFaults(std::string path, std::string what, std::string cure)
    : path_(std::move(path)), what_(std::move(what)), cure_(std::move(cure))
{
}

void CsvFaults::add(Index line, const std::string& what)
{
  if (++n_ <= most_shown) text_ += fmt::format("\n  {}:{}: {}", path_, line, what);
}

void CsvFaults::stop_if_any() const
{
  if (n_ == 0) return;
  std::string text = fmt::format("{} has {} fault{}:{}", what_, n_, n_ == 1 ? "" : "s", text_);
  if (n_ > most_shown) text += fmt::format("\n  and {} more", n_ - most_shown);
  throw CsvError(text + "\n  " + cure_);
}

std::optional<Real> number_in_csv(std::string_view text)
{
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  return number_from<Real>(text);
}

Real finite_number_in_csv(std::string_view text, std::string_view column, Index line, CsvFaults& faults)
{
  const std::optional<Real> value = number_in_csv(text);
  if (!value)
    faults.add(line, fmt::format("{} is `{}`, which is not a number{}", column, text,
                         text.find(',') == text.npos ? "" : decimal_point));
  else if (!std::isfinite(*value))
    faults.add(line, fmt::format("{} is {}; it must be finite", column, text));
  return value.value_or(0.0);
}

void read_csv_rows(const std::string& text, std::span<const std::string> columns, CsvFaults& faults,
    const std::function<void(std::span<const std::string>, Index)>& row)
{
  std::optional<Places> places;
  bool any = false, reported_commas = false;
  std::string_view rest = text;
  if (rest.substr(0, 64).find('\0') != std::string_view::npos || rest.starts_with("\xFF\xFE") ||
      rest.starts_with("\xFE\xFF")) {
    faults.add(1, "this is no text in UTF-8, more likely in UTF-16: save it as CSV in UTF-8");
    faults.stop_if_any();
  }
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // the mark that some spreadsheets put before UTF-8
  for (Index number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (says_nothing(line)) continue;
    if (std::ranges::count(line, '"') % 2 == 1) {
      faults.add(number, "a quote is not closed in its line; a quote in a text stands twice");
      if (!places) faults.stop_if_any();
      any = true;
      continue;
    }
    if (!places) {
      places = read_header(line, number, columns, faults);
      faults.stop_if_any();
      continue;
    }
    any = true;
    const auto cells = split(line);
    if (cells.size() != columns.size()) {
      const bool by_comma = cells.size() == 2 * columns.size() - 1 || cells.size() == 2 * columns.size();
      if (by_comma && std::exchange(reported_commas, true)) continue;
      faults.add(number,
          fmt::format("{} values, and {} columns{}", cells.size(), columns.size(), by_comma ? decimal_point : ""));
      continue;
    }
    std::vector<std::string> in_order;
    for (const std::size_t place : *places) in_order.push_back(cells[place]);
    row(in_order, number);
  }
  if (!any) faults.add(1, places ? "no rows below the names of the columns" : "the file is empty");
  faults.stop_if_any();
}

}  // namespace terp
