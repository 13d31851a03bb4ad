// The keys of [water] and [[water.situation]], and how their lines are read.

#include "math/checksum.hpp"
#include "io/case/document.hpp"
#include "io/case/expression.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/values.hpp"
#include "model/bodies/values_csv.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace terp {
namespace {

using Places = std::vector<Vec<2>>;

bool refuse_type(const Entry& entry, const Node& node, const std::string& path, Findings& findings)
{
  return refuse(entry, path, fmt::format("`{}` must be {}", last_part(entry.path), type_text(entry.key)),
      fmt::format("Got {}.", describe_value(node)), findings);
}

/// A line over x: one place or more, from left to right.
bool read_line(const Entry& entry, const Node& list, const std::string& path, Findings& findings, Places& line)
{
  Places places;
  if (!read_places(entry, list, path, findings, places)) return false;
  if (places.empty()) return refuse_type(entry, list, path, findings);
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k][0] < places[k - 1][0])
      return refuse(entry, fmt::format("{}[{}]", path, k), fmt::format("`{}` goes back in x", last_part(path)),
          fmt::format("From x = {} m to x = {} m. Give the places from left to right; a vertical step, two places with "
                      "one x, is allowed.",
              places[k - 1][0], places[k][0]),
          findings);
  line = places;
  return true;
}

std::string line_text(const Places& line)
{
  std::string text;
  for (const Vec<2>& x : line) text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", x[0], x[1]);
  return text.empty() ? text : '[' + text + ']';
}

OwnForm line_field(Places& line)
{
  return {"one or more places [[x, y], ...] from left to right",
      [&line](
          const Entry& entry, Findings& findings) { return read_line(entry, entry.node, entry.path, findings, line); },
      [&line] { return line_text(line); }};
}

bool read_head_lines(const Entry& entry, Findings& findings, std::vector<HeadLine>& lines)
{
  if (entry.node.kind != NodeKind::table) return refuse_type(entry, entry.node, entry.path, findings);
  bool good = true;
  for (const Node& item : entry.node.items) {
    const std::string path = join_path(entry.path, item.name);
    if (item.name == phreatic_head)
      good = refuse(entry, path, "a head line cannot be called `phreatic`",
          "That is the head of the phreatic line. Give it another name.", findings);
    HeadLine& line = lines.emplace_back(HeadLine{item.name, {}});
    good = read_line(entry, item, path, findings, line.places) && good;
  }
  return good;
}

std::string head_lines_text(const std::vector<HeadLine>& lines)
{
  std::string text;
  for (const HeadLine& line : lines)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", line.name, line_text(line.places));
  return text;
}

/// { line = ..., head = "NAME" }, or head_top and head_bottom.
bool read_reference_line(
    const Entry& entry, const Node& table, const std::string& path, Findings& findings, ReferenceLine& line)
{
  if (table.kind != NodeKind::table) return refuse_type(entry, table, path, findings);
  const Node* places = find_item(table, "line");
  if (places == nullptr)
    return refuse(entry, path, "a reference line has no `line`", "Give line = [[x, y], ...] in m.", findings);
  bool good = read_line(entry, *places, path + ".line", findings, line.places);
  for (const Node& item : table.items) {
    const std::string at = join_path(path, item.name);
    if (item.name == "line") continue;
    if (item.name != "head" && item.name != "head_top" && item.name != "head_bottom") {
      good = refuse(entry, at, fmt::format("unknown key `{}`", item.name),
          "Keys of a reference line: line, head, head_top, head_bottom", findings);
    } else if (item.kind != NodeKind::text) {
      good = refuse(entry, at, fmt::format("`{}` must be text", item.name),
          fmt::format("Got {}; allowed: the name of a head line, or \"phreatic\".", describe_value(item)), findings);
    } else {
      if (item.name != "head_bottom") line.head = item.text;
      if (item.name != "head_top") line.head_bottom = item.text;
    }
  }
  if (good && (line.head.empty() || line.head_bottom.empty()))
    return refuse(entry, path, "a reference line has no head",
        "Give head = \"NAME\" of a head line, or head_top, just above the line, and head_bottom, just below it.",
        findings);
  return good;
}

bool read_reference_lines(const Entry& entry, Findings& findings, std::vector<ReferenceLine>& lines)
{
  if (entry.node.kind != NodeKind::list) return refuse_type(entry, entry.node, entry.path, findings);
  bool good = true;
  for (std::size_t k = 0; k < entry.node.items.size(); ++k)
    good = read_reference_line(
               entry, entry.node.items[k], fmt::format("{}[{}]", entry.path, k), findings, lines.emplace_back()) &&
           good;
  return good;
}

std::string reference_lines_text(const std::vector<ReferenceLine>& lines)
{
  std::string text;
  for (const ReferenceLine& line : lines)
    text +=
        fmt::format("{}{{{}, {}, {}}}", text.empty() ? "" : ", ", line_text(line.places), line.head, line.head_bottom);
  return text;
}

bool read_formula(const Entry& entry, Findings& findings, WaterSituation& situation)
{
  if (entry.node.kind != NodeKind::text) return refuse_type(entry, entry.node, entry.path, findings);
  const std::string& text = entry.node.text;
  try {
    const Expression formula(text, {"x", "y", "t"}, {});
    situation.formula = [formula](Vec<2> x, Real time) {
      const std::array values{x[0], x[1], time};
      return formula(values);
    };
    situation.formula_text = text;
  } catch (const ExpressionError& error) {
    return refuse(entry, entry.path, fmt::format("`{}` is not a formula of x, y and t", last_part(entry.path)),
        error.what(), findings);
  }
  try {
    const Expression steady(text, {"x", "y"}, {});
    situation.formula_changes = false;
  } catch (const ExpressionError&) {
    situation.formula_changes = true;
  }
  return true;
}

/// { csv = "FILE.csv" }: values on a grid of places, pressures or heads.
bool read_grid(const Entry& entry, const std::string& folder, Findings& findings, WaterSituation& situation)
{
  const bool is_csv =
      entry.node.items.size() == 1 && entry.node.items[0].name == "csv" && entry.node.items[0].kind == NodeKind::text;
  if (entry.node.kind != NodeKind::table || !is_csv) return refuse_type(entry, entry.node, entry.path, findings);
  const std::string &name = entry.node.items[0].text, file = path_of(folder, name), path = entry.path + ".csv";
  if (!std::filesystem::is_regular_file(file)) return false;  // check_files says so
  try {
    const auto map = std::make_shared<const ValueMap>(read_values_csv(file));
    if (!map->is_grid() || std::isinf(map->low()[0]) || std::isinf(map->low()[1]))
      return refuse(entry, path, "the table of the water is no grid",
          "Give every x with every y, two or more of each: between them the values are bilinear.", findings);
    situation.formula = [map](Vec<2> x, Real) { return map->at(x); };
    situation.formula_text = fmt::format("csv {}", digits_of(read_file(file)));
    situation.formula_changes = false;
    situation.grid_file = name;
    situation.grid_low = map->low();
    situation.grid_high = map->high();
  } catch (const FileError& error) {
    return refuse(entry, path, "the table cannot be used", error.what(), findings);
  }
  return true;
}

std::string formula_text(const WaterSituation& situation)
{
  return situation.formula_text.empty() ? std::string() : quoted_list({situation.formula_text});
}

OwnForm pressure_field(WaterSituation& situation, const std::string& folder)
{
  return {"text: a formula of x, y and t; or { csv = \"FILE.csv\" }",
      [&situation, folder](const Entry& e, Findings& f) {
        return e.node.kind == NodeKind::table ? read_grid(e, folder, f, situation) : read_formula(e, f, situation);
      },
      [&situation] { return situation.formula_gives_head ? std::string() : formula_text(situation); }};
}

OwnForm head_field(WaterSituation& situation, const std::string& folder)
{
  return {"a table { csv = \"FILE.csv\" }",
      [&situation, folder](const Entry& e, Findings& f) {
        situation.formula_gives_head = true;
        return read_grid(e, folder, f, situation);
      },
      [&situation] { return situation.formula_gives_head ? formula_text(situation) : std::string(); }};
}

using SituationOf = WaterSituation& (*)(Case&, std::size_t);

std::vector<KeyInfo> situation_keys(const std::string& section, SituationOf of)
{
  return {
      {.path = section + ".phreatic_line",
          .field = [of](Case& c, std::size_t i) { return line_field(of(c, i).phreatic_line); },
          .unit = "m",
          .meaning = "elevation of the water table over x, constant beyond both ends. Above the ground it is the level "
                     "of free water, which loads the soil. Either this or pressure",
          .equation = "p_w = unit_weight (y_phreatic(x) - y) below the line"},
      {.path = section + ".head_lines",
          .field =
              [of](Case& c, std::size_t i) {
                std::vector<HeadLine>& lines = of(c, i).head_lines;
                return OwnForm{"a table { NAME = [[x, y], ...] } of lines from left to right",
                    [&lines](const Entry& e, Findings& f) { return read_head_lines(e, f, lines); },
                    [&lines] { return head_lines_text(lines); }};
              },
          .unit = "m",
          .meaning = "heads of layers under pressure, elevations over x with names for reference_lines"},
      {.path = section + ".reference_lines",
          .field =
              [of](Case& c, std::size_t i) {
                std::vector<ReferenceLine>& lines = of(c, i).reference_lines;
                return OwnForm{"a list of tables { line = [[x, y], ...], head = \"NAME\" }",
                    [&lines](const Entry& e, Findings& f) { return read_reference_lines(e, f, lines); },
                    [&lines] { return reference_lines_text(lines); }};
              },
          .unit = "m",
          .meaning =
              "lines in the soil at which the water has the head of a head line, or \"phreatic\". From the phreatic "
              "line down to the first its own head holds, between two lines it runs linearly, below the last it stays. "
              "head_top and head_bottom, instead of head: just above the line and just below it",
          .equation = "p_w = unit_weight (head(x, y) - y)"},
      {.path = section + ".pressure",
          .field = [of](Case& c, std::size_t i) { return pressure_field(of(c, i), c.folder); },
          .unit = "Pa",
          .meaning =
              "pore pressure as a formula of the place x, y [m] and the time t [s], instead of the lines: "
              "\"9810*max(2-y, 0)\"; or bilinear on a grid of places, { csv = \"FILE.csv\" } with the columns x, "
              "y, value, beyond it that of its nearest edge. What is negative counts as suction"},
      {.path = section + ".head",
          .field = [of](Case& c, std::size_t i) { return head_field(of(c, i), c.folder); },
          .unit = "m",
          .meaning = "elevation to which the water rises, on a grid of places as `pressure`, instead of the lines",
          .equation = "p_w = unit_weight (head(x, y) - y)"},
  };
}

WaterSituation& start_of(Case& c, std::size_t) { return c.water.start; }
WaterSituation& other_of(Case& c, std::size_t i) { return c.water.situations[i]; }

}  // namespace

std::vector<KeyInfo> water_keys()
{
  std::vector<KeyInfo> keys = situation_keys("water", start_of);
  keys.push_back({.path = "water.unit_weight",
      .field = [](Case& c, std::size_t) { return &c.water.unit_weight; },
      .unit = "N/m^3",
      .range = positive,
      .usual = between(9500.0, 10500.0),
      .meaning = "weight of the water per volume"});
  keys.push_back({.path = "water.suction",
      .field = [](Case& c, std::size_t) { return &c.water.suction; },
      .unit = "Pa",
      .range = not_negative,
      .usual = between(100.0, 100e3),
      .meaning = "largest suction above the phreatic line; it presses drained soil together, and 0 means none"});
  keys.push_back({.path = "water.follow_soil",
      .field = [](Case& c, std::size_t) { return &c.water.follow_soil; },
      .meaning = "whether the water table goes with soil that moves, and free water stays where water feeds it; false: "
                 "water is where the lines are, wherever the soil goes"});
  keys.push_back({.path = "water.situation[].name",
      .field = [](Case& c, std::size_t i) { return &c.water.situations[i].name; },
      .meaning = "name of this situation"});
  keys.push_back({.path = "water.situation[].time",
      .field = [](Case& c, std::size_t i) { return &c.water.situations[i].time; },
      .unit = "s",
      .range = positive,
      .meaning = "when this situation is reached; from the one before the pressure runs there linearly"});
  const auto add = [&](std::vector<KeyInfo> more) {
    for (KeyInfo& key : more) keys.push_back(std::move(key));
  };
  add(situation_keys("water.situation[]", other_of));
  add(seepage_keys());
  keys.push_back(level_key());
  add(seepage_keys_of_situation("water", start_of));
  add(seepage_keys_of_situation("water.situation[]", other_of));
  return keys;
}

void complete_situations(WaterCase& water)
{
  const WaterSituation& start = water.start;
  for (WaterSituation& situation : water.situations) {
    SeepageCase& seepage = situation.seepage;
    if (!seepage.river) seepage.river = start.seepage.river;
    if (seepage.ponds.empty()) seepage.ponds = start.seepage.ponds;
    if (seepage.boundary.empty()) seepage.boundary = start.seepage.boundary;
    if (!situation.is_given()) {
      situation.phreatic_line = start.phreatic_line;
      situation.formula = start.formula;
      situation.formula_text = start.formula_text;
      situation.formula_changes = start.formula_changes;
      situation.formula_gives_head = start.formula_gives_head;
      situation.grid_file = start.grid_file;
      situation.grid_low = start.grid_low;
      situation.grid_high = start.grid_high;
    }
    if (situation.formula) continue;
    if (situation.reference_lines.empty()) situation.reference_lines = start.reference_lines;
    for (const HeadLine& line : start.head_lines)
      if (std::ranges::find(situation.head_lines, line.name, &HeadLine::name) == situation.head_lines.end())
        situation.head_lines.push_back(line);
  }
}

}  // namespace terp
