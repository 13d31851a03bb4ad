// What a field needs of the case is entered in FieldNeeds. A number inside a field is read by store_value with a key
// made for it (key_like): units and ranges are as of any key. The range of values of shansep that are fields cannot be
// checked here, so `within` gives NaN outside of it, which is found when the points have places. field_text must change
// whenever a value does, as a run that goes on compares it; so files count by their content.

#include "io/case/field_kinds.hpp"

#include "math/checksum.hpp"
#include "math/closest.hpp"
#include "io/case/expression.hpp"
#include "io/case/key_text.hpp"
#include "io/case/random_kind.hpp"
#include "io/case/units.hpp"
#include "model/soils/soil_fields.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace terp {
namespace {

bool read_number(
    const FieldContext& context, const Node& node, const std::string& path, const KeyInfo& key, Real& value)
{
  return store_value({node, path, key}, &value, context.findings);
}

constexpr const char* far_off = "one value is eight times those beside it, or an eighth";

/// [[argument, value], ...]; the arguments ascend, or descend if `either`.
std::optional<std::vector<Vec<2>>> read_line(
    const Node& list, const FieldContext& context, const KeyInfo& argument, bool either = false)
{
  const std::string path = join_path(context.entry.path, list.name);
  if (list.kind != NodeKind::list || list.items.empty())
    return refuse_field(context, path, fmt::format("`{}` must be a list of pairs", list.name),
        fmt::format("Got {}; allowed: one pair or more, [[{}, value], ...].", describe_value(list), argument.unit));
  const KeyInfo& given = context.entry.key;
  const KeyInfo number = key_like(given, given.unit, given.range, given.usual);
  std::vector<Vec<2>> line;
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const Node& pair = list.items[k];
    const std::string at = fmt::format("{}[{}]", path, k);
    if (pair.kind != NodeKind::list || pair.items.size() != 2)
      return refuse_field(context, at, fmt::format("`{}` must be a list of pairs", list.name),
          fmt::format("Got {}; a pair has two numbers.", describe_value(pair)));
    Vec<2>& place = line.emplace_back();
    if (!read_number(context, pair.items[0], at + "[0]", argument, place[0]) ||
        !read_number(context, pair.items[1], at + "[1]", number, place[1]))
      return std::nullopt;
  }
  for (std::size_t k = 1; k + 1 < line.size(); ++k)
    if (lies_far_off(line[k][1], {line[k - 1][1], line[k + 1][1]}))
      context.findings.warnings.push_back({fmt::format("{}[{}][1]", path, k), far_off,
          fmt::format("Got {:g} between {:g} and {:g}. Did a decimal point slip, or is it in another unit?", line[k][1],
              line[k - 1][1], line[k + 1][1]),
          "field"});
  if (either && line.front()[0] > line.back()[0]) std::ranges::reverse(line);
  for (std::size_t k = 1; k < line.size(); ++k)
    if (line[k][0] < line[k - 1][0])
      return refuse_field(context, path, fmt::format("`{}` goes back", list.name),
          fmt::format("{} {} stands beside {} {}. Give the pairs in order; a step, two pairs with one {}, is allowed.",
              line[k - 1][0], argument.unit, line[k][0], argument.unit, argument.unit));
  return line;
}

/// Notes for which arguments there are values, and gives them.
std::optional<FieldValue> value_of_line(std::optional<std::vector<Vec<2>>> line, const FieldContext& context,
    std::string_view what, std::string_view unit, const FieldValue& argument)
{
  if (!line) return std::nullopt;
  if (line->front()[0] < line->back()[0])
    context.needs.reaches.push_back({what, unit, line->front()[0], line->back()[0], argument});
  return by_line(std::move(*line), argument);
}

std::optional<FieldValue> read_depth(const Node& value, const FieldContext& context)
{
  context.needs.outlines = true;
  return value_of_line(read_line(value, context, key_like(context.entry.key, "m", not_negative)), context, "depth", "m",
      depth_below_ground());
}

std::optional<FieldValue> read_elevation(const Node& value, const FieldContext& context)
{
  return value_of_line(read_line(value, context, key_like(context.entry.key, "m", any_number), true), context,
      "elevation", "m", elevation_in_soil());
}

std::optional<FieldValue> read_csv(const Node& value, const FieldContext& context)
{
  const std::string path = join_path(context.entry.path, value.name);
  if (value.kind != NodeKind::text)
    return refuse_field(context, path, "`csv` must be text",
        fmt::format("Got {}; allowed: the name of a file, relative to the case file.", describe_value(value)));
  const std::string file = path_of(context.folder, value.text);
  if (!std::filesystem::is_regular_file(file)) return std::nullopt;  // check_files says so
  try {
    ValueMap map = read_values_csv(file);
    context.needs.covers.push_back({value.text, map.low(), map.high()});
    if (constexpr Real most_of_it = 0.75; !map.is_grid() && map.share_of_grid() >= most_of_it)
      context.findings.warnings.push_back({path, "places are missing from the grid of this table",
          fmt::format("`{}` has {} places, {} of a grid. Without the others each value is a mean of the eight nearest "
                      "places, and not bilinear.\nLook for lines that are missing, and for coordinates that differ in "
                      "their last digits.",
              value.text, map.n_places(), std::lround(static_cast<Real>(map.n_places()) / map.share_of_grid())),
          "field"});
    if (const auto odd = map.find_far_off())
      context.findings.warnings.push_back({path, far_off,
          fmt::format(
              "`{}` has {:g} at x = {:g}, y = {:g}, far from all places beside it. Did a decimal point slip, or "
              "is it in another unit?",
              value.text, odd->value, odd->x[0], odd->x[1]),
          "field"});
    return by_map(std::move(map));
  } catch (const FileError& error) {
    return refuse_field(context, path, "the table cannot be used", error.what());
  }
}

constexpr std::string_view start_water = "start";  // as in `water` of a stage

/// A name of a situation among the keys of a table; the start if it is left out. None if it is no text.
std::optional<std::string> read_water(const Node& table, std::string_view name, const FieldContext& context)
{
  const Node* node = find_item(table, name);
  if (node == nullptr) return "";
  if (node->kind != NodeKind::text)
    return refuse_field(context, join_path(context.entry.path, name), fmt::format("`{}` must be text", name),
        fmt::format("Got {}; allowed: the name of a [[water.situation]].", describe_value(*node)));
  if (node->text == start_water) return "";
  context.needs.situations.push_back(node->text);
  return node->text;
}

std::string name_of_water(const std::string& name) { return name.empty() ? std::string(start_water) : name; }

std::string water_text(const std::string& name)
{
  return name.empty() ? "the water at the start" : fmt::format("the water `{}`", name);
}

void note(const FieldContext& context, const std::string& text)
{
  context.findings.notes.push_back(fmt::format("{}: {}", context.entry.path, text));
}

std::optional<FieldValue> read_table(const Node& value, const FieldContext& context)
{
  context.needs.stress = true;
  auto line = read_line(value, context, key_like(context.entry.key, "Pa", not_negative));
  if (line && context.entry.path.find(".su_") != std::string::npos && line->back()[1] > line->back()[0])
    context.findings.warnings.push_back({join_path(context.entry.path, value.name),
        "the strength is more than sigma'_v",
        fmt::format("At the last pair sigma'_v is {:g} Pa and the strength {:g} Pa. Are the columns swapped? A pair is "
                    "[sigma'_v, strength]; clay that never\nbore more has 0.2 to 0.35 times sigma'_v.",
            line->back()[0], line->back()[1]),
        "field"});
  const auto water = read_water(context.entry.node, "water", context);
  if (water) {
    context.needs.stress_water = name_of_water(*water);
    note(context, fmt::format("sigma'_v in {}", water_text(*water)));
  }
  if (!water) return std::nullopt;
  return value_of_line(std::move(line), context, "sigma'_v", "Pa", vertical_stress(*water));
}

struct ShansepKey {
  std::string_view name, unit;
  Range range, usual;
  FieldValue Shansep::*value;
  std::string_view meaning;
};

constexpr Range infinite_from_one{1.0};

// Usual values: docs/strength.md.
const ShansepKey shansep_keys[] = {
    {"S", "-", {0.0, 2.0, true, false}, between(0.1, 0.6), &Shansep::S, "normally consolidated strength ratio"},
    {"m", "-", {0.0, 1.0, true, false}, between(0.5, 1.0), &Shansep::m, "strength increase exponent"},
    {"pop", "Pa", not_negative, between(500.0, 1e6), &Shansep::pop, "sigma'_p - sigma'_v,daily"},
    {"ocr", "-", infinite_from_one, between(1.0, 50.0), &Shansep::ocr, "sigma'_p / sigma'_v,daily"},
    {"yield_stress", "Pa", positive, between(1e3, 1e7), &Shansep::yield_stress, "sigma'_p"},
    {"minimum", "Pa", positive, between(50.0, 1e5), &Shansep::minimum, "least S_u"},
};
constexpr std::string_view water_options[] = {"water", "daily_water"};

bool read_shansep_key(const Node& item, const ShansepKey& info, const FieldContext& context, Shansep& soil)
{
  const KeyInfo key = key_like(context.entry.key, info.unit, info.range, info.usual);
  const FieldContext inner{
      {item, join_path(context.entry.path, item.name), key}, context.folder, context.findings, context.needs};
  auto value = read_field(inner);
  if (!value) return false;
  soil.*info.value = item.kind == NodeKind::table || is_formula(item) ? within(info.range, std::move(*value)) : *value;
  return true;
}

std::optional<FieldValue> read_shansep(const Node& table, const FieldContext& outer)
{
  outer.needs.stress = true;
  const FieldContext context{
      {table, join_path(outer.entry.path, table.name), outer.entry.key}, outer.folder, outer.findings, outer.needs};
  if (outer.entry.key.unit != "Pa")
    return refuse_field(outer, context.entry.path, "SHANSEP gives a strength",
        fmt::format("It is in Pa; `{}` is in {}.", last_part(outer.entry.path), outer.entry.key.unit));
  if (table.kind != NodeKind::table)
    return refuse_field(outer, context.entry.path, "`shansep` must be a table",
        fmt::format("Got {}; write {{ S = 0.23, m = 0.9, pop = \"15 kPa\" }}.", describe_value(table)));
  std::vector<std::string> names;
  for (const ShansepKey& key : shansep_keys) names.emplace_back(key.name);
  names.insert(names.end(), std::begin(water_options), std::end(water_options));
  Shansep soil;
  bool good = !refuse_unknown_keys(table, names, context);
  for (const ShansepKey& key : shansep_keys)
    if (const Node* item = find_item(table, key.name)) good = read_shansep_key(*item, key, context, soil) && good;
  const auto water = read_water(table, "water", context), daily = read_water(table, "daily_water", context);
  if (!good || !water || !daily) return std::nullopt;
  if (!soil.S || !soil.m)
    return refuse_field(context, context.entry.path, fmt::format("`shansep` has no `{}`", soil.S ? "m" : "S"),
        "S_u = S sigma'_v (sigma'_p / sigma'_v)^m. Dutch defaults: clay S = 0.22, m = 0.9; peat S = 0.27, m = 0.9.");
  if (static_cast<bool>(soil.pop || soil.yield_stress) + static_cast<bool>(soil.ocr) != 1)
    return refuse_field(context, context.entry.path, "`shansep` needs one of `pop`, `ocr` and `yield_stress`",
        "They say what sigma'_p is: sigma'_v,daily + pop, ocr sigma'_v,daily, or the stress itself. Give exactly one; "
        "a\n`pop` beside `yield_stress` is added to that.");
  context.needs.stress_water = name_of_water(*water);
  if (!soil.yield_stress) context.needs.daily_water = name_of_water(*daily);
  note(outer, fmt::format("SHANSEP, sigma'_v in {}{}", water_text(*water),
                  soil.yield_stress ? "" : ", sigma'_p from that in " + water_text(*daily)));
  soil.water = *water;
  soil.daily = *daily;
  context.needs.yield_stress = yield_stress_of(soil);
  return by_shansep(soil);
}

constexpr std::string_view yield_stress_name = "yield_stress";  ///< of laws and of SHANSEP

/// sigma'_p by `pop` or `ocr`, the name of the item: what SHANSEP has for both.
std::optional<FieldValue> read_yield_stress(const Node& value, const FieldContext& context)
{
  context.needs.stress = true;
  if (last_part(context.entry.key.path) != yield_stress_name && last_part(context.entry.path) != yield_stress_name)
    return refuse_field(context, join_path(context.entry.path, value.name),
        fmt::format("`{}` gives a yield stress", value.name),
        fmt::format("`{}` is none: this kind of field is for `{}` alone.{}", last_part(context.entry.path),
            yield_stress_name,
            context.entry.key.unit == "Pa" ? " A strength by it is shansep = { S, m, pop or ocr }." : ""));
  Shansep soil;
  const auto daily = read_water(context.entry.node, "daily_water", context);
  const auto* key = std::ranges::find(shansep_keys, value.name, &ShansepKey::name);
  if (!daily || !read_shansep_key(value, *key, context, soil)) return std::nullopt;
  soil.daily = *daily;
  context.needs.daily_water = name_of_water(*daily);
  note(context, fmt::format("sigma'_p from sigma'_v in {}", water_text(*daily)));
  return context.needs.yield_stress = yield_stress_of(soil);
}

std::optional<FieldValue> read_formula(const FieldContext& context)
{
  const std::string& text = context.entry.node.text;
  try {
    const Expression formula(text, {"x", "y"}, {});
    return [formula](const PlaceInSoil& at) { return formula(at.x); };
  } catch (const ExpressionError& error) {
    return refuse_field(context, context.entry.path,
        fmt::format("`{}` is not a formula of x and y", last_part(context.entry.path)),
        fmt::format("{}\nGot \"{}\"; its numbers are in SI: {}.", error.what(), text,
            context.entry.key.unit == "-" ? "x and y in m" : "x and y in m, the value in " + context.entry.key.unit));
  }
}

std::optional<FieldValue> read_kind(const FieldContext& context)
{
  const Node& table = context.entry.node;
  std::vector<std::string> names;
  const FieldKind* found = nullptr;
  for (const FieldKind& kind : field_kinds()) {
    names.emplace_back(kind.name);
    if (find_item(table, kind.name) == nullptr) continue;
    if (found != nullptr)
      return refuse_field(context, context.entry.path,
          fmt::format(
              "`{}` is given in two ways, `{}` and `{}`", last_part(context.entry.path), found->name, kind.name),
          "Remove one of the two.");
    found = &kind;
  }
  for (const Node& item : table.items) {
    if (found != nullptr &&
        (item.name == found->name || std::ranges::find(found->options, item.name) != found->options.end()))
      continue;
    return refuse_field(context, join_path(context.entry.path, item.name),
        fmt::format("`{}` is no kind of field{}", item.name,
            found == nullptr ? "" : fmt::format(", nor an option of `{}`", found->name)),
        did_you_mean(item.name, names) + "Kinds: " + plain_list(names));
  }
  if (found == nullptr)
    return refuse_field(context, context.entry.path,
        fmt::format("`{}` is an empty table", last_part(context.entry.path)), "Kinds of field: " + plain_list(names));
  return found->read(*find_item(table, found->name), context);
}

/// Names of files become what is in them: a run holds copies with other names.
void replace_files(Node& node, const std::string& folder)
{
  if (node.name == "csv" && node.kind == NodeKind::text) try {
      node.text = digits_of(read_file(path_of(folder, node.text)));
    } catch (const FileError&) {  // reported where it is read
    }
  for (Node& item : node.items) replace_files(item, folder);
}

}  // namespace

std::nullopt_t refuse_field(const FieldContext& context, const std::string& path, std::string what, std::string detail)
{
  context.findings.problems.push_back({path, std::move(what), std::move(detail), "field"});
  return std::nullopt;
}

bool refuse_unknown_keys(const Node& table, const std::vector<std::string>& names, const FieldContext& context)
{
  bool any = false;
  for (const Node& item : table.items) {
    if (std::ranges::find(names, item.name) != names.end()) continue;
    refuse_field(context, join_path(context.entry.path, item.name), fmt::format("unknown key `{}`", item.name),
        fmt::format("{}Keys of {}: {}", did_you_mean(item.name, names), table.name, plain_list(names)));
    context.findings.problems.back().at_key = any = true;
  }
  return any;
}

KeyInfo key_like(const KeyInfo& key, std::string_view unit, Range range, Range usual)
{
  KeyInfo other = key;
  other.unit = unit;
  other.range = range;
  other.usual = usual;
  other.field = [](Case& c, std::size_t) { return &c.time.end; };  // a number, for messages
  return other;
}

const std::vector<FieldKind>& field_kinds()
{
  static const std::vector<FieldKind> kinds = {
      {"depth", "{ depth = [[0, 8e3], [5, 15e3]] }",
          "linear in the depth below the ground at that x [m], constant beyond both ends", {}, read_depth},
      {"elevation", "{ elevation = [[-8, 20e3], [0, 8e3]] }",
          "linear in the elevation y [m], constant beyond both ends", {}, read_elevation},
      {"csv", "{ csv = \"FILE.csv\" }",
          "from a file with the columns x, y, value: bilinear where the places form a grid, else the mean of the eight "
          "nearest by inverse square distance",
          {}, read_csv},
      {"table", "{ table = [[0, 2e3], [50e3, 14e3]], water = \"NAME\" }",
          "linear in the effective vertical stress [Pa] at t = 0, constant beyond both ends; water: the situation that "
          "gives it, if not the start",
          {"water"}, read_table},
      {"shansep", "{ shansep = { S = 0.23, m = 0.9, pop = 15e3 } }",
          "S_u = S sigma'_v (sigma'_p / sigma'_v)^m, sigma'_p = sigma'_v,daily + pop, or by ocr or yield_stress; also "
          "minimum, water and daily_water: situations of sigma'_v and sigma'_v,daily, if not the start",
          {}, read_shansep},
      {"pop", "{ pop = 15e3 }",
          "of a yield stress: sigma'_v,daily + pop; daily_water: the situation of sigma'_v,daily, if not the start",
          {"daily_water"}, read_yield_stress},
      {"ocr", "{ ocr = 1.3 }", "of a yield stress: ocr times sigma'_v,daily; daily_water as of pop", {"daily_water"},
          read_yield_stress},
      {"random", "{ random = { mean = 20e3, cov = 0.2, theta = [10, 0.5], box = [[0, -5], [40, 0]], seed = 1 } }",
          "a random field about a mean, with a separable correlation; the same on any mesh", {}, read_random},
  };
  return kinds;
}

bool is_key_of_shansep(std::string_view name)
{
  return std::ranges::find(shansep_keys, name, &ShansepKey::name) != std::end(shansep_keys) ||
         std::ranges::find(water_options, name) != std::end(water_options);
}

bool is_formula(const Node& node)
{
  if (node.kind != NodeKind::text) return false;
  const auto quantity = parse_quantity(node.text);
  return !quantity || std::string_view("+-*/^()<>=!&|?").find(quantity->name.front()) != std::string_view::npos;
}

std::optional<FieldValue> read_field(const FieldContext& context)
{
  const Node& node = context.entry.node;
  if (is_formula(node)) return read_formula(context);
  if (node.kind == NodeKind::table) return read_kind(context);
  Real value = 0.0;
  if (!store_value(context.entry, &value, context.findings)) return std::nullopt;
  return [value](const PlaceInSoil&) { return value; };
}

std::string field_text(const Node& node, const std::string& folder)
{
  Node root;
  root.items = {node};
  replace_files(root, folder);
  root.items[0].name = "field";
  return write_toml(root);
}

std::string describe_field_kinds()
{
  std::string out =
      "field: how a parameter of a law may vary over the soil, instead of a number\n  Values are set once, at t = 0, "
      "and go with the soil. docs/strength.md\n\nKinds\n  \"10e3 + 1.5e3*(0 - y)\"\n    a formula of the place x, y "
      "[m]\n";
  for (const FieldKind& kind : field_kinds()) out += fmt::format("  {}\n    {}\n", kind.form, kind.meaning);
  out += "\nKeys of shansep, each a number or a field\n";
  for (const ShansepKey& key : shansep_keys)
    out += fmt::format("  {:<14}[{}] {}; {}, usual {}\n", key.name, key.unit, key.meaning,
        range_text(key.range, key.unit), usual_text(key.usual, key.unit));
  return out + "\nKeys of random\n" + describe_random_keys();
}

}  // namespace terp
