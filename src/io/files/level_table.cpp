#include "io/files/level_table.hpp"

#include "math/errors.hpp"
#include "math/number_from.hpp"
#include "os/csv.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace terp {
namespace {

constexpr Real no_value = -99.0;  // and below: what stations write where they have no level [m]

/// Without the spaces around them.
std::vector<std::string> cells_of(std::string_view line)
{
  std::vector<std::string> cells = csv_cells(line, line.find(';') != std::string_view::npos ? ';' : ',');
  for (std::string& cell : cells) {
    cell.erase(cell.find_last_not_of(" \r") + 1);
    cell.erase(0, cell.find_first_not_of(' '));
  }
  return cells;
}

std::optional<Real> number_of_cell(std::string text)
{
  std::ranges::replace(text, ',', '.');
  const std::optional<Real> value = number_from<Real>(std::string_view(text).substr(text.starts_with('+') ? 1 : 0));
  return value && std::isfinite(*value) ? value : std::nullopt;
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
    if (std::string_view("-/: TZ").find(c) == std::string_view::npos || word.size() > 4) return std::nullopt;
    if (!word.empty()) numbers.push_back(std::stoi(word));
    word.clear();
  }
  if (numbers.size() < 3 || numbers.size() > 6) return std::nullopt;
  if (numbers[0] < 32 && numbers[2] > 31) std::swap(numbers[0], numbers[2]);
  numbers.resize(6, 0);
  const std::chrono::year_month_day date{std::chrono::year(numbers[0]),
      std::chrono::month(static_cast<unsigned>(numbers[1])), std::chrono::day(static_cast<unsigned>(numbers[2]))};
  if (numbers[0] < 1000 || !date.ok() || numbers[3] > 24 || numbers[4] > 59 || numbers[5] > 60) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<Real>(days) * 86400.0 + numbers[3] * 3600.0 + numbers[4] * 60.0 + numbers[5];
}

}  // namespace

LevelTable read_level_table(const std::string& path, Real unit)
{
  return read_level_table_text(path, read_file(path), unit);
}

LevelTable read_level_table_text(const std::string& path, std::string_view text, Real unit)
{
  LevelTable table;
  LevelWave& wave = table.wave;
  bool is_first = true, has_dates = false;
  std::size_t begin = 0, n_levels = 0;
  for (int line = 1; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::vector<std::string> cells = cells_of(text.substr(begin, end - begin));
    begin = end + 1;
    if ((cells.size() == 1 && cells[0].empty()) || cells[0].starts_with('#')) continue;
    const auto fail = [&](const std::string& why) { throw FileError(fmt::format("{}:{}: {}", path, line, why)); };
    std::optional<Real> time = number_of_cell(cells[0]);
    if (time)
      *time *= unit;
    else if ((time = date_of_cell(cells[0])))
      has_dates = true;
    if (is_first) n_levels = cells.size() - 1;
    if (!time && is_first) {
      wave.names.assign(cells.begin() + 1, cells.end());
      is_first = false;
      continue;
    }
    is_first = false;
    if (!time) fail(fmt::format("`{}` is no time: a number, or a date as 2026-01-05 12:30", cells[0]));
    if (cells.size() != n_levels + 1 || n_levels == 0)
      fail(fmt::format("it has {} cells; a row has a time and {} level{}", cells.size(),
          std::max<std::size_t>(n_levels, 1), n_levels > 1 ? "s" : ""));
    std::vector<Real> levels;
    bool is_gap = false;
    for (std::size_t k = 1; k < cells.size(); ++k) {
      const std::optional<Real> level = number_of_cell(cells[k]);
      is_gap |= cells[k].empty() || cells[k] == "nan" || cells[k] == "NaN" || (level && *level <= no_value);
      if (!level && !is_gap) fail(fmt::format("`{}` is no level in m", cells[k]));
      levels.push_back(level.value_or(0.0));
    }
    if (is_gap) {
      ++table.gaps;
      continue;
    }
    if (!wave.times.empty() && !(*time > wave.times.back())) fail("the times do not grow");
    wave.times.push_back(*time);
    wave.levels.push_back(std::move(levels));
  }
  if (wave.times.size() < 2)
    throw FileError(fmt::format("{}: it has {} row{} with a level; a series has two or more", path, wave.times.size(),
        wave.times.size() == 1 ? "" : "s"));
  if (has_dates)
    for (Real first = wave.times.front(); Real & time : wave.times) time -= first;
  return table;
}

}  // namespace terp
