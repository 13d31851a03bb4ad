#include "points/points_csv.hpp"

#include "base/closest.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <optional>
#include <sstream>

namespace terp {
namespace {

constexpr std::int64_t most_shown = 10;
const std::array<std::string, 4> columns{"x", "y", "volume", "material"};

class Faults {
 public:
  explicit Faults(const std::string& path) : path_(path) {}

  void add(Index line, const std::string& what)
  {
    if (++n_ <= most_shown) text_ += fmt::format("\n  {}:{}: {}", path_, line, what);
  }

  void stop_if_any() const
  {
    if (n_ == 0) return;
    std::string text = fmt::format("the table of points has {} fault{}:{}", n_, n_ == 1 ? "" : "s", text_);
    if (n_ > most_shown) text += fmt::format("\n  and {} more", n_ - most_shown);
    throw PointsFileError(
        text +
        fmt::format("\n  It has the columns {}: m, m, m^2 (volume per metre of thickness), and a material of the case.",
            fmt::join(columns, ", ")));
  }

 private:
  std::string path_, text_;
  std::int64_t n_ = 0;
};

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view line)
{
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    std::string_view cell = trimmed(line.substr(0, comma));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    cells.push_back(cell);
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// Place of each column in a line, shape [4].
using Places = std::array<std::size_t, 4>;

/// What stands between the names instead of commas, in words; empty if commas do, or if there is one name.
std::string other_separator(std::string_view line)
{
  if (line.find(',') != std::string_view::npos) return "";
  if (line.find(';') != std::string_view::npos) return "semicolons";
  if (line.find('\t') != std::string_view::npos) return "tabs";
  return line.find(' ') != std::string_view::npos ? "blanks" : "";
}

Places read_header(std::string_view line, Index number, Faults& faults)
{
  if (const std::string other = other_separator(line); !other.empty()) {
    faults.add(number, fmt::format("the values are separated by {}; Terp reads commas, and a decimal point in numbers. "
                                   "In a spreadsheet: save as CSV with commas, language English",
                           other));
    return {};
  }
  const auto names = split(line);
  for (const std::string_view name : names) {
    if (std::ranges::find(columns, name) != columns.end()) continue;
    const std::string meant = closest(name, {columns.begin(), columns.end()});
    faults.add(
        number, fmt::format("unknown column `{}`{}", name, meant.empty() ? "" : "; did you mean `" + meant + "`?"));
  }
  Places places{};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto n = std::ranges::count(names, columns[k]);
    if (n == 0) faults.add(number, fmt::format("no column `{}`", columns[k]));
    if (n > 1) faults.add(number, fmt::format("column `{}` is there {} times", columns[k], n));
    places[k] = static_cast<std::size_t>(std::ranges::find(names, columns[k]) - names.begin());
  }
  return places;
}

/// A sign in front may be a plus, as in TOML.
std::optional<Real> number_in(std::string_view text)
{
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Real value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The point of one line; faults are noted, and the point is then of no use.
CsvPoint read_row(std::string_view line, Index number, const Places& places, Faults& faults)
{
  CsvPoint point{{0.0, 0.0}, 0.0, "", number};
  const auto cells = split(line);
  if (cells.size() != columns.size()) {
    const bool by_comma = cells.size() == 2 * columns.size() - 1;  // each of three numbers in two parts
    faults.add(number, fmt::format("{} values, and 4 columns{}", cells.size(),
                           by_comma ? "; numbers have a decimal point, no comma" : ""));
    return point;
  }
  const std::array<Real*, 3> numbers{&point.x[0], &point.x[1], &point.volume};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::string_view text = cells[places[k]];
    const std::optional<Real> value = number_in(text);
    if (!value)
      faults.add(number, fmt::format("{} is `{}`, which is not a number", columns[k], text));
    else if (!std::isfinite(*value))
      faults.add(number, fmt::format("{} is {}; it must be finite", columns[k], text));
    else if (k == 2 && *value <= 0.0)
      faults.add(number, fmt::format("volume is {} m^2; it must be greater than 0", text));
    *numbers[k] = value.value_or(0.0);
  }
  point.material = cells[places[3]];
  if (point.material.empty()) faults.add(number, "material is empty");
  return point;
}

bool says_nothing(std::string_view line) { return line.empty() || line.front() == '#'; }

}  // namespace

std::vector<CsvPoint> read_points_csv_text(const std::string& path, const std::string& text)
{
  std::vector<CsvPoint> points;
  std::optional<Places> places;
  Faults faults(path);
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // the mark that some spreadsheets put before UTF-8
  for (Index number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (says_nothing(line)) continue;
    if (places) {
      points.push_back(read_row(line, number, *places, faults));
    } else {
      places = read_header(line, number, faults);
      faults.stop_if_any();
    }
  }
  if (points.empty()) faults.add(1, places ? "no points below the names of the columns" : "the file is empty");
  faults.stop_if_any();
  return points;
}

std::vector<CsvPoint> read_points_csv(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file || file.bad()) throw PointsFileError(fmt::format("cannot read the table of points {}", path));
  return read_points_csv_text(path, text.str());
}

}  // namespace terp
