// The key water.level: a table of river levels over time, as a measuring station or a forecast gives it.

#include "io/case/document.hpp"
#include "io/case/expression.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/units.hpp"
#include "io/case/values.hpp"
#include "math/closest.hpp"
#include "math/number_from.hpp"
#include "model/water/level_series.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace terp {
namespace {

struct TimeUnit {
  std::string_view name;
  Real seconds;
};
constexpr TimeUnit time_units[] = {{"h", 3600.0}, {"min", 60.0}, {"s", 1.0}, {"d", 86400.0}};

/// A level series cannot be read; what() says where and why.
class SeriesError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::vector<std::string> cells_of(std::string_view line)
{
  const char separator = line.find(';') != std::string_view::npos ? ';' : ',';
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == separator)
      cells.emplace_back();
    else if (c != '"' && c != '\r')
      cells.back() += c;
  }
  for (std::string& cell : cells) {
    while (!cell.empty() && cell.back() == ' ') cell.pop_back();
    cell.erase(0, std::min(cell.find_first_not_of(' '), cell.size()));
  }
  return cells;
}

/// A number; with semicolons between the cells a comma is its point.
std::optional<Real> number_of_cell(std::string text)
{
  std::ranges::replace(text, ',', '.');
  const std::optional<Real> value = number_from<Real>(std::string_view(text).substr(text.starts_with('+') ? 1 : 0));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Days from 1970-01-01 of a date of the Gregorian calendar.
std::int64_t days_from_date(int year, int month, int day)
{
  year -= month <= 2;
  const std::int64_t era = (year >= 0 ? year : year - 399) / 400;
  const int of_era = static_cast<int>(year - era * 400),
            of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
}

/// "2026-01-05 12:30", "2026-01-05T12:30:00Z", "05-01-2026 12:30" [s].
std::optional<Real> date_of_cell(const std::string& text)
{
  std::vector<int> numbers;
  std::string word;
  for (const char c : text + ' ') {
    if (c >= '0' && c <= '9') {
      word += c;
      continue;
    }
    if (std::string_view("-/: TZ").find(c) == std::string_view::npos) return std::nullopt;
    if (!word.empty()) numbers.push_back(word.size() > 4 ? -1 : std::stoi(word));
    word.clear();
  }
  if (numbers.size() < 3 || numbers.size() > 6 || std::ranges::find(numbers, -1) != numbers.end()) return std::nullopt;
  if (numbers[0] < 32 && numbers[2] > 31) std::swap(numbers[0], numbers[2]);
  numbers.resize(6, 0);
  const auto [year, month, day, h, min, s] =
      std::array{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]};
  if (year < 1000 || month < 1 || month > 12 || day < 1 || day > 31 || h > 24 || min > 59 || s > 60)
    return std::nullopt;
  return static_cast<Real>(days_from_date(year, month, day)) * 86400.0 + h * 3600.0 + min * 60.0 + s;
}

/// Rows without a level are gaps: between its neighbours the level is linear anyway.
void read_table(const std::string& file, Real unit, LevelSeries& series, int& gaps)
{
  const std::string text = read_file(file);
  std::size_t begin = 0;
  bool is_first = true;
  for (int line = 1; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view row = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    const std::vector<std::string> cells = cells_of(row);
    if ((cells.size() == 1 && cells[0].empty()) || cells[0].starts_with('#')) continue;
    const auto fail = [&](const std::string& why) { throw SeriesError(fmt::format("{}:{}: {}", file, line, why)); };
    std::optional<Real> time = number_of_cell(cells[0]);
    if (time)
      *time *= unit;
    else
      time = date_of_cell(cells[0]);
    if (!time && is_first) {  // names of the columns
      is_first = false;
      continue;
    }
    is_first = false;
    if (!time) fail(fmt::format("`{}` is no time: a number, or a date as 2026-01-05 12:30", cells[0]));
    if (cells.size() < 2) fail("there is no level beside the time");
    const std::optional<Real> level = number_of_cell(cells[1]);
    const bool is_gap = cells[1].empty() || cells[1] == "nan" || cells[1] == "NaN" || (level && *level <= -99.0);
    if (is_gap) {
      ++gaps;
      continue;
    }
    if (!level) fail(fmt::format("`{}` is no level in m", cells[1]));
    if (!series.times.empty() && !(*time > series.times.back())) fail("the times do not grow");
    series.times.push_back(*time);
    series.levels.push_back(*level);
  }
  if (series.times.size() < 2)
    throw SeriesError(fmt::format("{}: it has {} level{}; a series has two or more", file, series.times.size(),
        series.times.size() == 1 ? "" : "s"));
}

/// A number, or a formula of `level`.
std::function<Real(Real)> formula_of_level(const Node& node)
{
  if (const std::optional<Real> number = number_of(node, "m")) return [value = *number](Real) { return value; };
  if (node.kind != NodeKind::text) throw SeriesError("a place has numbers in m or formulas of `level`");
  try {
    const Expression formula(node.text, {"level"}, {});
    return [formula](Real level) { return formula(std::array{level}); };
  } catch (const ExpressionError& error) {
    throw SeriesError(error.what());
  }
}

bool read_level(const Entry& entry, Findings& findings, const std::string& folder, std::optional<LevelSeries>& into)
{
  static const std::vector<std::string> names{"csv", "unit", "shorten", "side", "phreatic_line"};
  if (entry.node.kind != NodeKind::table)
    return refuse(entry, entry.path, "`level` must be a table",
        "Give { csv = \"levels.csv\", unit = \"h\" }. One level that stays is a place of phreatic_line.", findings);
  LevelSeries series;
  Real unit = 3600.0;
  for (const Node& item : entry.node.items) {
    const std::string path = join_path(entry.path, item.name);
    if (std::ranges::find(names, item.name) == names.end())
      return refuse(entry, path, fmt::format("unknown key `{}`", item.name),
          did_you_mean(item.name, names) + fmt::format("Keys of it: {}", plain_list(names)), findings);
    if (item.name == "unit") {
      const auto found = std::ranges::find(time_units, std::string_view(item.text), &TimeUnit::name);
      if (item.kind != NodeKind::text || found == std::end(time_units))
        return refuse(entry, path, "`unit` must be one of \"h\", \"min\", \"s\", \"d\"",
            fmt::format("Got {}. It is that of the times in the table.", describe_value(item)), findings);
      unit = found->seconds;
    } else if (item.name == "shorten") {
      const std::optional<Real> factor = number_of(item, "-");
      if (!factor || !(*factor > 0.0))
        return refuse(entry, path, "`shorten` must be a number, more than 0",
            "Seconds of the series that take one second of the run: 3600, the default, makes an hour a second.",
            findings);
      series.shorten = *factor;
    } else if (item.name == "side") {
      if (item.text != "left" && item.text != "right")
        return refuse(entry, path, "`side` must be one of \"left\", \"right\"",
            fmt::format("Got {}.", describe_value(item)), findings);
      series.side = item.text == "left" ? RiverSide::left : RiverSide::right;
    } else if (item.name == "phreatic_line") {
      try {
        for (const Node& place : item.items) {
          if (place.items.size() != 2) throw SeriesError("a place is [x, y]");
          series.line.push_back({formula_of_level(place.items[0]), formula_of_level(place.items[1])});
        }
      } catch (const SeriesError& error) {
        return refuse(entry, path, "`phreatic_line` of a series is a list of places [x, y]",
            fmt::format("{}. Each is a number in m or a formula: [[0, \"level\"], [20, \"0.5*level\"], [40, 0]].",
                error.what()),
            findings);
      }
    }
  }
  const Node* csv = find_item(entry.node, "csv");
  if (csv == nullptr || csv->kind != NodeKind::text)
    return refuse(
        entry, entry.path, "`level` has no `csv`", "Give csv = \"FILE.csv\" with the columns time, level.", findings);
  const std::string file = path_of(folder, csv->text);
  if (!std::filesystem::is_regular_file(file)) return false;  // check_files says so
  int gaps = 0;
  try {
    read_table(file, unit, series, gaps);
  } catch (const std::runtime_error& error) {
    return refuse(entry, entry.path + ".csv", "the table of levels cannot be used", error.what(), findings);
  }
  findings.notes.push_back(fmt::format("{}: {}{}", entry.path, describe(series),
      gaps == 0 ? "" : fmt::format("; {} row{} without a level left out", gaps, gaps == 1 ? "" : "s")));
  into = std::move(series);
  return true;
}

}  // namespace

KeyInfo level_key()
{
  return {.path = "water.level",
      .field =
          [](Case& c, std::size_t) {
            return OwnForm{"a table { csv = \"levels.csv\", unit = \"h\", shorten = 3600, side = \"left\" }",
                [&c](const Entry& e, Findings& f) { return read_level(e, f, c.folder, c.water.series); },
                [&c] { return c.water.series ? quoted_list({describe(*c.water.series)}) : std::string(); }};
          },
      .unit = "m",
      .meaning =
          "levels of the river over time, a table with the columns time and level. unit: of numbers in the first, h, "
          "min, s or d; dates have none. shorten: seconds of the series in one second of the run. The phreatic line "
          "of each level is phreatic_line = [[x, y], ...] of this table, with formulas of `level`; left out: the level "
          "up to the ground, then straight to the toe on land"};
}

}  // namespace terp
