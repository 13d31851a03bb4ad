// Types and defaults are written down nowhere: the accessor of a key is called on a case with one of everything. The
// Field that it gives has the type, and what it points at is the default.

#include "io/case/key_text.hpp"

#include "io/case/key_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace terp {
namespace {

/// A case with one of everything, so that every key's field exists.
Case& prototype()
{
  static Case one = [] {
    Case c;
    for (const SectionInfo& section : all_sections()) count_entries(c, section.path, true);
    c.materials.push_back({"", "", 0.0, std::vector<Real>(64, 0.0)});
    c.materials[0].ratios.resize(64);
    c.sides.resize(1);
    return c;
  }();
  return one;
}

template <class List, class ToText>
std::string joined(const List& list, ToText&& to_text)
{
  std::string text;
  for (const auto& entry : list) text += (text.empty() ? "" : ", ") + to_text(entry);
  return text;
}

std::string with_unit(std::string text, std::string_view unit)
{
  if (unit != "-" && !unit.empty()) text += ' ', text += unit;
  return text;
}

}  // namespace

std::string number_text(Real value, std::string_view unit) { return with_unit(fmt::format("{}", value), unit); }

std::string converted_text(Real value, std::string_view unit)
{
  const Real rounded = std::stod(fmt::format("{:.6g}", value));  // then as short as it can be: 4000000, not 4e+06
  return number_text(std::isfinite(value) ? rounded : value, unit);
}

std::string range_text(const Range& range, std::string_view unit)
{
  std::string text;
  if (std::isfinite(range.low)) text = fmt::format("{} {}", range.low_open ? "more than" : "at least", range.low);
  if (std::isfinite(range.high)) {
    if (!text.empty()) text += " and ";
    text += fmt::format("{} {}", range.high_open ? "less than" : "at most", range.high);
  }
  return text.empty() ? text : with_unit(text, unit);
}

std::string usual_text(const Range& usual, std::string_view unit)
{
  const bool is_closed = std::isfinite(usual.low) && std::isfinite(usual.high);
  return is_closed ? with_unit(fmt::format("{} to {}", usual.low, usual.high), unit) : range_text(usual, unit);
}

std::string type_text(const KeyInfo& key)
{
  const Overload type{
      [](Real*) { return "a number"; },
      [](const VaryingNumber&) { return "a number or a field"; },
      [](Index*) { return "an integer"; },
      [](bool*) { return "true or false"; },
      [](std::string*) { return "text"; },
      [](Vec<2>*) { return "two numbers [x, y]"; },
      [](const WordField&) { return "text"; },
      [](const NumberOrPair&) { return "a number or two numbers [x, y]"; },
      [](const CountOrPair&) { return "an integer or two integers [nx, ny]"; },
      [](const Box&) { return "two corners [[x0, y0], [x1, y1]]"; },
      [](const BoxCorners&) { return "two corners [[x0, y0], [x1, y1]]"; },
      [](const PolygonField&) { return "at least three corners [[x, y], [x, y], [x, y]]"; },
      [](const PolygonList&) { return "a list of polygons [[[x, y], [x, y], [x, y]], ...], each of three or more"; },
      [](const Polyline&) { return "at least two places [[x, y], [x, y]]"; },
      [](const EdgesList&) { return "a table { NAME = [k, ...] } of edge numbers"; },
      [](const VelocityPair&) { return "two numbers or formulas [x, y]"; },
      [](const NameList&) { return "a list of names"; },
      [](const NamedPlaces&) { return "a table { NAME = [x, y] }"; },
      [](const OwnForm& form) { return form.type.c_str(); },
  };
  const Field field = key.field(prototype(), 0);
  return std::visit(type, field);
}

Field example_of(const KeyInfo& key) { return key.field(prototype(), 0); }

std::string allowed_text(const KeyInfo& key)
{
  const bool is_list = std::holds_alternative<NameList>(key.field(prototype(), 0));
  if (key.words != nullptr) return (is_list ? "a list of " : "") + quoted_list(key.words());
  const std::string range = range_text(key.range, key.unit);
  if (range.empty()) return type_text(key) + (key.unit == "-" || key.unit.empty() ? "" : " in " + key.unit);
  return type_text(key) + ", " + range;
}

std::string value_text(const KeyInfo& key, const Field& field)
{
  const auto pair = [](const auto& v) { return fmt::format("[{}, {}]", v[0], v[1]); };
  const auto places = [&](const std::vector<Vec<2>>& list) {
    return list.empty() ? std::string() : '[' + joined(list, pair) + ']';
  };
  const auto word = [&](const WordField& choice) {
    const auto words = key.words();
    const int index = choice.get();
    return index >= 0 && index < static_cast<int>(words.size()) ? quoted_list({words[index]}) : std::string();
  };
  const Overload text{
      [](const Real* value) { return std::isnan(*value) ? std::string() : fmt::format("{}", *value); },
      [](const VaryingNumber& kept) {
        if (kept.field != nullptr) return kept.field->text;
        return std::isnan(*kept.value) ? std::string() : fmt::format("{}", *kept.value);
      },
      [](const Index* value) { return fmt::format("{}", *value); },
      [](const bool* value) { return fmt::format("{}", *value); },
      [](const std::string* value) { return value->empty() ? *value : quoted_list({*value}); },
      [&](const Vec<2>* value) { return pair(*value); },
      [&](const WordField& choice) { return word(choice); },
      [&](const NumberOrPair& kept) { return pair(*kept.value); },
      [&](const CountOrPair& kept) { return pair(*kept.value); },
      [&](const Box& kept) { return places(*kept.corners); },
      [&](const BoxCorners& kept) {
        return places({*kept.low, *kept.high});
      },
      [&](const PolygonField& kept) { return places(*kept.corners); },
      [&](const PolygonList& kept) { return joined(*kept.polygons, places); },
      [&](const Polyline& kept) { return places(*kept.places); },
      [](const EdgesList& kept) {
        return joined(*kept.sides,
            [](const EdgesCase& side) { return fmt::format("{} = [{}]", side.side, fmt::join(side.edges, ", ")); });
      },
      [&](const VelocityPair& kept) { return pair(*kept.value); },
      [](const NameList& kept) { return quoted_list(*kept.names); },
      [&](const NamedPlaces& kept) {
        return joined(*kept.places, [&](const auto& named) { return named.first + " = " + pair(named.second); });
      },
      [](const OwnForm& form) { return form.text(); },
  };
  return std::visit(text, field);
}

std::string default_text(const KeyInfo& key)
{
  if (key.required || !key.required_for.empty()) return "";
  const Field field = key.field(prototype(), 0);
  const Overload none{
      [](const BoxCorners&) { return std::string(); },
      [](const PolygonList&) { return std::string("none"); },
      [](const EdgesList&) { return std::string("none"); },
      [&](const NameList&) { return std::string(key.words != nullptr ? "all" : "none"); },
      [](const NamedPlaces&) { return std::string("none"); },
      [&](const auto& kept) {
        const std::string text = value_text(key, kept);
        return text.empty() ? text : with_unit(text, key.unit);
      },
  };
  return std::visit(none, field);
}

std::string quoted_list(const std::vector<std::string>& words)
{
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "\"" : ", \"") + word + '"';
  return list;
}

std::string plain_list(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::string last_part(std::string_view path)
{
  if (path.ends_with(".NAME") || path.ends_with(".SIDE")) path.remove_suffix(5);
  if (path.ends_with("[]")) path.remove_suffix(2);
  const std::size_t dot = path.rfind('.');
  return std::string(dot == std::string_view::npos ? path : path.substr(dot + 1));
}

std::string parent_path(std::string_view path)
{
  if (path.ends_with(".NAME")) path.remove_suffix(5);
  const std::size_t dot = path.rfind('.');
  return std::string(dot == std::string_view::npos ? "" : path.substr(0, dot));
}

std::string topic_of(std::string_view path)
{
  std::string topic(path);
  for (const std::string_view mark : {"[]", ".NAME", ".SIDE"})
    if (const std::size_t at = topic.find(mark); at != std::string::npos) topic.erase(at, mark.size());
  return topic;
}

std::string header_of(std::string_view section)
{
  const bool is_list = section.ends_with("[]");
  if (is_list) section.remove_suffix(2);
  return is_list ? fmt::format("[[{}]]", section) : fmt::format("[{}]", section);
}

}  // namespace terp
