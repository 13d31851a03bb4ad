// One function for each type that a Field may hold; unit, range and words come from the key. A number is taken from its
// unit to SI first, then held against the range, and last against what is usual: that only warns. A text in place of a
// number is a number with a unit, or a formula where the type allows one. A value with a problem may leave a part of
// itself in the case: later checks must bear that.

#include "io/case/values.hpp"

#include "math/closest.hpp"
#include "io/case/field_kinds.hpp"
#include "io/case/key_text.hpp"
#include "io/case/syntax_advice.hpp"
#include "io/case/units.hpp"
#include "model/bodies/body_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

class ValueReader {
 public:
  ValueReader(const Entry& entry, Findings& findings) : entry_(entry), key_(entry.key), findings_(findings) {}

  bool operator()(Real* value) { return read_number(entry_.node, entry_.path, *value); }
  bool operator()(const VaryingNumber& number);
  bool operator()(Index* value) { return read_count(entry_.node, entry_.path, *value); }
  bool operator()(Vec<2>* value) { return read_pair(entry_.node, entry_.path, *value); }
  bool operator()(bool* value)
  {
    if (entry_.node.kind != NodeKind::boolean) return wrong_type(entry_.node, entry_.path);
    *value = entry_.node.boolean;
    return true;
  }
  bool operator()(std::string* value)
  {
    if (!read_word(entry_.node, entry_.path)) return false;
    *value = entry_.node.text;
    return true;
  }
  bool operator()(const WordField& field)
  {
    if (!read_word(entry_.node, entry_.path)) return false;
    const auto words = key_.words();
    field.set(static_cast<int>(std::ranges::find(words, entry_.node.text) - words.begin()));
    return true;
  }
  bool operator()(const NumberOrPair& field)
  {
    if (entry_.node.kind == NodeKind::list) return read_pair(entry_.node, entry_.path, *field.value);
    Real both = 0.0;
    if (!read_number(entry_.node, entry_.path, both)) return false;
    *field.value = {both, both};
    return true;
  }
  bool operator()(const CountOrPair& field);
  bool operator()(const Box& field);
  bool operator()(const BoxCorners& field) { return read_box(*field.low, *field.high); }
  bool operator()(const PolygonField& field)
  {
    return read_polygon(entry_.node, entry_.path, field.keeps_order, *field.corners);
  }
  bool operator()(const PolygonList& field);
  bool operator()(const Polyline& field);
  bool operator()(const EdgesList& field);
  bool operator()(const VelocityPair& field);
  bool operator()(const NameList& field);
  bool operator()(const NamedPlaces& field);
  bool operator()(const OwnForm& field) { return field.read(entry_, findings_); }
  bool read_places(const Node& list, const std::string& path, std::vector<Vec<2>>& places);

 private:
  bool read_number(const Node& node, const std::string& path, Real& value);
  bool read_count(const Node& node, const std::string& path, Index& value);
  bool read_pair(const Node& node, const std::string& path, Vec<2>& value);
  bool read_box(Vec<2>& low, Vec<2>& high);
  bool read_polygon(const Node& list, const std::string& path, bool keeps_order, std::vector<Vec<2>>& polygon);
  bool read_word(const Node& node, const std::string& path);

  bool wrong_type(const Node& node, const std::string& path);
  bool wrong_unit(const Node& node, const std::string& path, const NumberWithUnit& quantity);
  bool out_of_range(const std::string& path, const std::string& got);
  bool not_finite(const std::string& path, Real number);
  std::string example_of_unit(const std::string& number) const;
  bool fail(const std::string& path, std::string what, std::string detail);
  std::string name() const { return last_part(entry_.path); }

  const Entry& entry_;
  const KeyInfo& key_;
  Findings& findings_;
};

/// A pair with decimal commas is a list of four whole numbers: [0,0, -9,81].
std::string advice_on_decimal_commas(const Node& list)
{
  const auto is_whole = [](const Node& item) { return item.kind == NodeKind::integer; };
  if (list.kind != NodeKind::list || list.items.size() != 4 || !std::ranges::all_of(list.items, is_whole)) return "";
  const auto& it = list.items;
  if (it[1].integer < 0 || it[3].integer < 0) return "";
  return fmt::format(" If the commas are decimal ones, write [{}.{}, {}.{}].", it[0].integer, it[1].integer,
      it[2].integer, it[3].integer);
}

bool ValueReader::fail(const std::string& path, std::string what, std::string detail)
{
  findings_.problems.push_back({path, std::move(what), std::move(detail), topic_of(key_.path)});
  return false;
}

bool ValueReader::wrong_type(const Node& node, const std::string& path)
{
  return fail(path, fmt::format("`{}` must be {}", name(), type_text(key_)),
      fmt::format("Got {}; allowed: {}.", describe_value(node), allowed_text(key_)) + advice_on_decimal_commas(node));
}

bool ValueReader::out_of_range(const std::string& path, const std::string& got)
{
  const std::string range = range_text(key_.range, key_.unit);
  return fail(path, fmt::format("`{}` is out of range", name()),
      fmt::format("Got {}; allowed: {}.", got, range.empty() ? "any finite number" : range));
}

bool ValueReader::not_finite(const std::string& path, Real number)
{
  const std::string range = range_text(key_.range, key_.unit);
  const std::string unit = key_.unit == "-" ? "" : " in " + key_.unit;
  return fail(path, fmt::format("`{}` must be a finite number", name()),
      fmt::format(
          "Got {}; allowed: a finite number{}.", number_text(number, key_.unit), range.empty() ? unit : ", " + range));
}

bool ValueReader::wrong_unit(const Node& node, const std::string& path, const NumberWithUnit& quantity)
{
  const std::vector<std::string> fitting = units_of_key(key_.unit);
  const bool has_unit = key_.unit != "-";
  const std::string allowed = fmt::format("Got \"{}\"; allowed: a plain number{}{}.\n", node.text,
      has_unit ? " in " + key_.unit : "", fitting.empty() ? "" : ", or a text with one of: " + plain_list(fitting));
  if (const auto cure = quantity.name.starts_with(',') ? advise_on_commas(node.text) : std::nullopt)
    return fail(path, fmt::format("`{}` has a decimal point, no comma", name()), allowed + *cure);
  if (quantity.unit == nullptr) {
    const std::string nearest = closest(quantity.name, fitting.empty() ? all_unit_names() : fitting);
    return fail(path, fmt::format("`{}` has a unit that Terp does not know, `{}`", name(), quantity.name),
        allowed + (nearest.empty() ? example_of_unit(quantity.number) : fmt::format("Did you mean `{}`?", nearest)));
  }
  return fail(path, fmt::format("`{}` cannot be in {}", name(), quantity.name),
      allowed +
          fmt::format("{} is of a key in {}. ", quantity.name,
              quantity.unit->of_key == "-" ? "no unit" : quantity.unit->of_key) +
          example_of_unit(quantity.number));
}

/// How a number of this key may be written.
std::string ValueReader::example_of_unit(const std::string& number) const
{
  const std::vector<std::string> fitting = units_of_key(key_.unit);
  if (fitting.empty() || key_.unit == "-") return "Write a number without a unit.";
  return fmt::format("Write, for example, \"{} {}\".", number, fitting.front());
}

/// What an unusual number may have been meant to be.
std::string advice_on_unit(Real number, const std::string& unit)
{
  const std::vector<std::string> units = units_of_key(unit);
  if (unit != "deg" && (unit == "-" || units.empty())) return "Terp reads SI units: m, kg, s, Pa.";
  if (unit != "deg")
    return fmt::format("Terp reads SI units: m, kg, s, Pa. Others are named: \"{} {}\".", number, units.front());
  constexpr Real degree = 3.14159265358979323846 / 180.0;
  return fmt::format("Angles are in degrees: {0} rad are {1:.1f} deg, and {0} is the tangent of {2:.1f} deg.", number,
      number / degree, std::atan(number) / degree);
}

bool ValueReader::read_number(const Node& node, const std::string& path, Real& value)
{
  const auto quantity = node.kind == NodeKind::text ? parse_quantity(node.text) : std::nullopt;
  const auto in_si = number_of(node, key_.unit);
  if (!in_si) return quantity ? wrong_unit(node, path, *quantity) : wrong_type(node, path);
  const Real number = *in_si;
  const std::string got = quantity ? fmt::format("\"{}\", {}", node.text, converted_text(number, key_.unit))
                                   : number_text(number, key_.unit);
  if (!std::isfinite(number) && !key_.may_be_infinite) return not_finite(path, number);
  if (!key_.range.contains(number)) return out_of_range(path, got);
  if (quantity) findings_.notes.push_back(fmt::format("{}: {}", path, got));
  if (number != 0.0 && std::isfinite(number) && !key_.usual.contains(std::abs(number)))
    findings_.warnings.push_back({path, fmt::format("`{}` = {} is unusual", name(), got),
        fmt::format("Usual: {}.", usual_text(key_.usual, key_.unit)) +
            (quantity ? "" : ' ' + advice_on_unit(number, key_.unit)),
        topic_of(key_.path)});
  value = number;
  return true;
}

bool ValueReader::read_count(const Node& node, const std::string& path, Index& value)
{
  if (node.kind != NodeKind::integer) return wrong_type(node, path);
  const bool fits =
      node.integer >= std::numeric_limits<Index>::min() && node.integer <= std::numeric_limits<Index>::max();
  if (!fits || !key_.range.contains(static_cast<Real>(node.integer)))
    return out_of_range(path, fmt::format("{}", node.integer));
  value = static_cast<Index>(node.integer);
  return true;
}

bool ValueReader::read_pair(const Node& node, const std::string& path, Vec<2>& value)
{
  if (node.kind != NodeKind::list || node.items.size() != 2) return wrong_type(node, path);
  const bool first = read_number(node.items[0], path + "[0]", value[0]);
  return read_number(node.items[1], path + "[1]", value[1]) && first;
}

bool ValueReader::read_places(const Node& list, const std::string& path, std::vector<Vec<2>>& places)
{
  if (list.kind != NodeKind::list) return wrong_type(list, path);
  places.resize(list.items.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    if (!read_pair(list.items[k], fmt::format("{}[{}]", path, k), places[k])) return false;
  return true;
}

bool ValueReader::read_word(const Node& node, const std::string& path)
{
  if (node.kind != NodeKind::text) return wrong_type(node, path);
  if (key_.words == nullptr || key_.more_words) return true;
  const auto words = key_.words();
  if (std::ranges::find(words, node.text) != words.end()) return true;
  const std::string hint = did_you_mean(node.text, words);
  return fail(path, fmt::format("`{}` cannot be \"{}\"", name(), node.text), hint + "Allowed: " + quoted_list(words));
}

bool ValueReader::operator()(const VaryingNumber& number)
{
  const Node& node = entry_.node;
  if (node.kind != NodeKind::table && !is_formula(node)) return read_number(node, entry_.path, *number.value);
  ParameterField field{.parameter = 0, .value_at = {}, .text = field_text(node, *number.folder), .needs = {}};
  auto value = read_field({entry_, *number.folder, findings_, field.needs});
  if (!value) return false;
  field.value_at = std::move(*value);
  number.set(std::move(field));
  return true;
}

bool ValueReader::operator()(const CountOrPair& field)
{
  const Node& node = entry_.node;
  auto& counts = *field.value;
  if (node.kind != NodeKind::list) {
    if (!read_count(node, entry_.path, counts[0])) return false;
    counts[1] = counts[0];
    return true;
  }
  if (node.items.size() != 2) return wrong_type(node, entry_.path);
  return read_count(node.items[0], entry_.path + "[0]", counts[0]) &&
         read_count(node.items[1], entry_.path + "[1]", counts[1]);
}

bool ValueReader::read_box(Vec<2>& low, Vec<2>& high)
{
  std::vector<Vec<2>> corners;
  if (!read_places(entry_.node, entry_.path, corners)) return false;
  if (corners.size() != 2) return wrong_type(entry_.node, entry_.path);
  low = corners[0], high = corners[1];
  if (low[0] >= high[0] || low[1] >= high[1])
    return fail(entry_.path, fmt::format("`{}` has no area", name()),
        fmt::format("Got [[{}, {}], [{}, {}]] m; the lower left corner comes first, then the upper right.", low[0],
            low[1], high[0], high[1]));
  return true;
}

bool ValueReader::operator()(const Box& field)
{
  Vec<2> low{}, high{};
  if (!read_box(low, high)) return false;
  *field.corners = {low, {high[0], low[1]}, high, {low[0], high[1]}};
  return true;
}

bool ValueReader::read_polygon(
    const Node& list, const std::string& path, bool keeps_order, std::vector<Vec<2>>& polygon)
{
  std::vector<Vec<2>> corners;
  if (!read_places(list, path, corners)) return false;
  if (corners.size() < 3) return wrong_type(list, path);
  if (const auto faults = check_outline({.polygon = corners, .points_per_cell = {1, 1}}); !faults.empty()) {
    const std::string fault = faults[0].substr(std::string_view("the polygon ").size());
    const std::size_t colon = std::min(fault.find(": "), fault.size());
    return fail(path, fmt::format("`{}` {}", last_part(path), fault.substr(0, colon)),
        (colon < fault.size() ? "Found" + fault.substr(colon) + ".\n" : "") +
            "Give the corners in order along the outline.");
  }
  if (signed_area(corners) < 0.0 && !keeps_order) std::ranges::reverse(corners);
  polygon = corners;
  return true;
}

bool ValueReader::operator()(const PolygonList& field)
{
  const Node& list = entry_.node;
  if (list.kind != NodeKind::list) return wrong_type(list, entry_.path);
  bool good = true;
  for (std::size_t k = 0; k < list.items.size(); ++k)
    good = read_polygon(list.items[k], fmt::format("{}[{}]", entry_.path, k), false, field.polygons->emplace_back()) &&
           good;
  return good;
}

bool ValueReader::operator()(const Polyline& field)
{
  std::vector<Vec<2>> places;
  if (!read_places(entry_.node, entry_.path, places)) return false;
  if (places.size() < 2) return wrong_type(entry_.node, entry_.path);
  const auto twice = std::ranges::adjacent_find(places);
  if (twice != places.end())
    return fail(entry_.path, fmt::format("`{}` names the same place twice in a row", name()),
        fmt::format("({}, {}) m. Remove one of the two.", (*twice)[0], (*twice)[1]));
  *field.places = places;
  return true;
}

bool ValueReader::operator()(const EdgesList& field)
{
  const Node& table = entry_.node;
  if (table.kind != NodeKind::table) return wrong_type(table, entry_.path);
  bool good = true;
  for (const Node& side : table.items) {
    const std::string path = join_path(entry_.path, side.name);
    if (side.kind != NodeKind::list || side.items.empty()) {
      good = wrong_type(side, path);
      continue;
    }
    EdgesCase& edges = field.sides->emplace_back();
    edges.side = side.name;
    for (std::size_t k = 0; k < side.items.size(); ++k) {
      Index edge = 0;
      if (read_count(side.items[k], fmt::format("{}[{}]", path, k), edge))
        edges.edges.push_back(edge);
      else
        good = false;
    }
  }
  return good;
}

bool ValueReader::operator()(const VelocityPair& field)
{
  const Node& list = entry_.node;
  const bool is_pair = list.kind == NodeKind::list && list.items.size() == 2;
  if (!is_pair) return wrong_type(list, entry_.path);
  if (std::ranges::none_of(list.items, is_formula)) return read_pair(list, entry_.path, *field.value);
  std::array<FieldValue, 2> parts;
  FieldNeeds none;
  for (std::size_t d = 0; d < 2; ++d) {
    const std::string path = fmt::format("{}[{}]", entry_.path, d);
    if (list.items[d].kind == NodeKind::table) return wrong_type(list.items[d], path);
    auto part = read_field({{list.items[d], path, key_}, "", findings_, none});
    if (!part) {
      findings_.problems.back().topic = topic_of(key_.path);
      return false;
    }
    parts[d] = std::move(*part);
  }
  *field.at = [parts](Vec<2> x) -> Vec<2> { return {parts[0]({x}), parts[1]({x})}; };
  return true;
}

bool ValueReader::operator()(const NameList& field)
{
  const Node& list = entry_.node;
  if (list.kind != NodeKind::list) return wrong_type(list, entry_.path);
  bool good = true;
  for (std::size_t k = 0; k < list.items.size(); ++k)
    good = read_word(list.items[k], fmt::format("{}[{}]", entry_.path, k)) && good;
  for (const Node& item : list.items)
    if (good) field.names->push_back(item.text);
  return good;
}

bool ValueReader::operator()(const NamedPlaces& field)
{
  const Node& table = entry_.node;
  if (table.kind != NodeKind::table) return wrong_type(table, entry_.path);
  bool good = true;
  for (const Node& item : table.items) {
    Vec<2> place{};
    good = read_pair(item, join_path(entry_.path, item.name), place) && good;
    field.places->emplace_back(item.name, place);
  }
  return good;
}

}  // namespace

bool refuse(const Entry& entry, const std::string& path, std::string what, std::string detail, Findings& findings)
{
  findings.problems.push_back({path, std::move(what), std::move(detail), topic_of(entry.key.path)});
  return false;
}

bool store_value(const Entry& entry, const Field& field, Findings& findings)
{
  return std::visit(ValueReader(entry, findings), field);
}

bool read_places(
    const Entry& entry, const Node& list, const std::string& path, Findings& findings, std::vector<Vec<2>>& places)
{
  return ValueReader(entry, findings).read_places(list, path, places);
}

std::string describe_value(const Node& node)
{
  switch (node.kind) {
    case NodeKind::boolean: return node.boolean ? "true" : "false";
    case NodeKind::integer: return fmt::format("the integer {}", node.integer);
    case NodeKind::number: return fmt::format("the number {}", node.number);
    case NodeKind::text: return fmt::format("the text \"{}\"", node.text);
    case NodeKind::list: return fmt::format("a list of {}", node.items.size());
    case NodeKind::table: return "a table";
    case NodeKind::date: break;
  }
  return "a date or time";
}

}  // namespace terp
