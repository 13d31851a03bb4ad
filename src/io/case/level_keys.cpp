// The key water.level: a table of river levels over time, as a measuring station or a forecast gives it.

#include "io/case/document.hpp"
#include "io/case/expression.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/units.hpp"
#include "io/case/values.hpp"
#include "io/files/level_table.hpp"
#include "math/closest.hpp"
#include "model/water/level_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace terp {
namespace {

struct TimeUnit {
  std::string_view name;
  Real seconds;
};
constexpr TimeUnit time_units[] = {{"h", 3600.0}, {"min", 60.0}, {"s", 1.0}, {"d", 86400.0}};

/// A number, or a formula of `level`. Throws ExpressionError.
std::function<Real(Real)> formula_of_level(const Node& node)
{
  if (const std::optional<Real> number = number_of(node, "m")) return [value = *number](Real) { return value; };
  if (node.kind != NodeKind::text) throw ExpressionError("a place has numbers in m or formulas of `level`");
  return [formula = Expression(node.text, {"level"}, {})](Real level) { return formula(std::array{level}); };
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
          if (place.items.size() != 2) throw ExpressionError("a place is [x, y]");
          series.line.push_back({formula_of_level(place.items[0]), formula_of_level(place.items[1])});
        }
      } catch (const ExpressionError& error) {
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
  try {
    const LevelTable table = read_level_table(file, unit);
    series.times = table.wave.times;
    for (const std::vector<Real>& levels : table.wave.levels) series.levels.push_back(levels[0]);
    findings.notes.push_back(fmt::format("{}: {}{}", entry.path, describe(series),
        table.gaps == 0 ? ""
                        : fmt::format("; {} row{} without a level left out", table.gaps, table.gaps == 1 ? "" : "s")));
  } catch (const FileError& error) {
    return refuse(entry, entry.path + ".csv", "the table of levels cannot be used", error.what(), findings);
  }
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
