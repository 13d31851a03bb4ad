#include "io/files/level_wave.hpp"

#include "model/bodies/csv_rows.hpp"
#include "os/read_file.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real hour = 3600.0;  // [s]

/// Names of the first line that is neither empty nor a remark.
std::vector<std::string> columns_of(const std::string& text)
{
  std::vector<std::string> names(1);
  bool in_quotes = false;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    const char c = k < text.size() ? text[k] : '\n';
    if (c == '"')
      in_quotes = !in_quotes;
    else if (c == ',' && !in_quotes)
      names.emplace_back();
    else if (c == '\n') {
      const bool is_empty = names.size() == 1 && (names[0].empty() || names[0][0] == '#');
      if (!is_empty) break;
      names.assign(1, "");
    } else if (c != '\r' && !(names.back().empty() && c == ' '))
      names.back() += c;
  }
  for (std::string& name : names)
    while (!name.empty() && name.back() == ' ') name.pop_back();
  return names;
}

}  // namespace

LevelWave read_level_wave(const std::string& path)
{
  const std::string text = read_file(path);
  CsvFaults faults(path, "the table of levels",
      "It has the columns hours and the names of levels: river, and those of ponds and heads of the case.");
  std::vector<std::string> columns = columns_of(text);
  LevelWave wave;
  for (const std::string& name : columns)
    if (name != "hours") wave.names.push_back(name);
  if (wave.names.size() == columns.size() || wave.names.empty())
    faults.add(1, "the columns are hours and at least one level");
  faults.stop_if_any();
  columns.assign(1, "hours");
  columns.insert(columns.end(), wave.names.begin(), wave.names.end());
  read_csv_rows(text, columns, faults, [&](std::span<const std::string> cells, Index line) {
    const Real time = hour * finite_number_in_csv(cells[0], "hours", line, faults);
    if (!wave.times.empty() && !(time > wave.times.back())) faults.add(line, "the hours do not grow");
    wave.times.push_back(time);
    std::vector<Real>& levels = wave.levels.emplace_back();
    for (std::size_t k = 1; k < cells.size(); ++k)
      levels.push_back(finite_number_in_csv(cells[k], columns[k], line, faults));
  });
  if (wave.times.empty()) faults.add(1, "there is no row");
  faults.stop_if_any();
  return wave;
}

}  // namespace terp
