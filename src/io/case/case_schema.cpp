// Each key becomes a property of the object that its path leads to. Names that the user chooses (of materials, head
// lines, points, sides of a mesh) are additional properties. A number with a unit may be a text.
#include "io/case/explain.hpp"

#include "io/case/document.hpp"
#include "io/case/expression.hpp"
#include "io/case/field_kinds.hpp"
#include "io/case/key_text.hpp"
#include "io/case/keys.hpp"
#include "io/case/units.hpp"
#include "soil/laws/material.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

/// A number with one of the units of the key, in all spellings.
std::string pattern_of_units(const std::vector<std::string>& units)
{
  std::string names;
  for (const std::string& unit : units) {
    if (!names.empty()) names += '|';
    for (const char c : unit)
      names += c == '2' ? "\\^?[2²]" : c == '3' ? "\\^?[3³]" : c == ' ' ? "[ ·*]" : std::string(1, c);
  }
  if (std::ranges::find(units, "deg") != units.end()) names += "|°";
  return "^\\s*[-+]?\\.?[0-9][-+0-9._eE]*\\s*(" + names + ")\\s*$";
}

Json number_schema(const KeyInfo& key)
{
  const std::vector<std::string> units = units_of_key(key.unit);
  const bool takes_units = key.unit != "-" && !units.empty();
  Json number = {{"type", takes_units ? Json({"number", "string"}) : Json("number")}};
  if (takes_units) number["pattern"] = pattern_of_units(units);
  if (std::isfinite(key.range.low)) number[key.range.low_open ? "exclusiveMinimum" : "minimum"] = key.range.low;
  if (std::isfinite(key.range.high)) number[key.range.high_open ? "exclusiveMaximum" : "maximum"] = key.range.high;
  return number;
}

Json count_schema(const KeyInfo& key)
{
  Json count = number_schema(key);
  count["type"] = "integer";
  return count;
}

Json list_of(Json item, int least, int most = 0)
{
  Json list = {{"type", "array"}, {"items", std::move(item)}, {"minItems", least}};
  if (most > 0) list["maxItems"] = most;
  return list;
}

Json either(Json a, Json b) { return {{"anyOf", {std::move(a), std::move(b)}}}; }
Json table_of(Json value) { return {{"type", "object"}, {"additionalProperties", std::move(value)}}; }

/// A formula of x and y, whose words are known, so that a number with a wrong unit is none; or a table of one kind.
Json field_schema()
{
  const std::string words = fmt::format("{}", fmt::join(names_in_formulas(), "|"));
  Json table = {{"type", "object"}};
  for (const FieldKind& kind : field_kinds()) {
    table["properties"][kind.name] = Json::object();
    for (const std::string_view option : kind.options) table["properties"][option] = Json::object();
  }
  return either({{"type", "string"}, {"pattern", "^([^A-Za-z_]|[0-9.][eE]|\\b(x|y|" + words + ")\\b)+$"}}, table);
}

Json text_schema(const KeyInfo& key)
{
  Json text = {{"type", "string"}};
  if (key.words != nullptr) text["enum"] = key.words();
  return text;
}

/// Of a value with a form of its own, by the words that say it; where they say more than one kind, any.
Json schema_of_form(const std::string& form, const KeyInfo& key)
{
  if (form.find("; or") != std::string::npos) return Json::object();
  if (form.starts_with("text")) return text_schema(key);
  if (form == "a number") return number_schema(key);
  if (form == "an integer") return count_schema(key);
  if (form.starts_with("a list") || form.starts_with("one or more")) return {{"type", "array"}};
  if (form.starts_with("a table")) return {{"type", "object"}};
  if (form.starts_with("numbers [")) return {{"type", {"array", "object"}}};
  if (form.starts_with("the number of")) return {{"type", {"integer", "array", "object"}}};
  return Json::object();
}

Json value_schema(const KeyInfo& key)
{
  const Json number = number_schema(key), place = list_of({{"type", {"number", "string"}}}, 2, 2);
  const Overload schema{
      [&](Real*) { return number; },
      [&](const VaryingNumber&) {
        return either(number, {{"$ref", "#/definitions/field"}});
      },
      [&](Index*) { return count_schema(key); },
      [](bool*) {
        return Json{{"type", "boolean"}};
      },
      [&](std::string*) { return text_schema(key); },
      [&](Vec<2>*) { return list_of(number, 2, 2); },
      [&](const WordField&) { return text_schema(key); },
      [&](const NumberOrPair&) { return either(number, list_of(number, 2, 2)); },
      [&](const CountOrPair&) { return either(count_schema(key), list_of(count_schema(key), 2, 2)); },
      [&](const Box&) { return list_of(place, 2, 2); },
      [&](const BoxCorners&) { return list_of(place, 2, 2); },
      [&](const PolygonField&) { return list_of(place, 3); },
      [&](const PolygonList&) { return list_of(list_of(place, 3), 0); },
      [&](const Polyline&) { return list_of(place, 1); },
      [](const EdgesList&) {
        return table_of(list_of({{"type", "integer"}}, 1));
      },
      [&](const VelocityPair&) { return place; },
      [&](const NameList&) { return list_of(text_schema(key), 0); },
      [&](const NamedPlaces&) { return table_of(place); },
      [&](const OwnForm& form) { return schema_of_form(form.type, key); },
  };
  return std::visit(schema, example_of(key));
}

Json property(const KeyInfo& key)
{
  Json value = value_schema(key);
  const std::string unit = key.unit == "-" ? "" : fmt::format(" [{}]", key.unit);
  value["description"] = fmt::format("{}{}. Allowed: {}.{}", key.meaning, unit, allowed_text(key),
      key.default_text.empty() ? "" : fmt::format(" Default: {}.", key.default_text));
  return value;
}

/// What stands at a path, made on the way there: of a table "properties", of a list of tables "items", of names that
/// the user chooses "additionalProperties".
Json& value_at(Json& root, const std::string& path)
{
  Json* here = &root;
  const auto enter = [&](const char* type, const char* kind) -> Json& {
    (*here)["type"] = type;
    return (*here)[kind];
  };
  for (const std::string& part : split_path(path)) {
    const bool is_name = part == "NAME" || part == "SIDE";
    if (part.starts_with('['))
      here = &enter("array", "items");
    else
      here = is_name ? &enter("object", "additionalProperties") : &enter("object", "properties")[part];
    if (!here->is_object()) *here = Json::object();
  }
  return *here;
}

void close_tables(Json& value)
{
  if (value.is_array())
    for (Json& item : value) close_tables(item);
  if (!value.is_object()) return;
  for (auto& [name, item] : value.items()) close_tables(item);
  if (value.contains("properties") && value["properties"].is_object() && !value.contains("additionalProperties"))
    value["additionalProperties"] = false;
}

void add(Json& root, const KeyInfo& key)
{
  Json& value = value_at(root, key.path);
  value = value.contains("properties") ? either(property(key), Json(value)) : property(key);
}

/// Names of a material for which a key stands at `path`, with what lies below it; "": of none.
std::string name_in_material(const std::string& path)
{
  const std::vector<std::string> parts = split_path(path);
  return parts.size() > 2 && parts[0] == "material" ? parts[2] : "";
}

/// A soil takes the keys of its own law alone, and needs those for which nothing else can stand. Of a soil of two parts
/// nothing is said: it has its keys here and there.
Json rules_of_soil()
{
  std::vector<std::string> common;
  for (const KeyInfo& key : all_keys())
    if (const std::string name = name_in_material(key.path); !name.empty()) common.push_back(name);
  const Json parts = {{{"required", {"below"}}}, {{"required", {"above"}}}};
  Json rules = Json::array({{{"anyOf", {{{"required", {"model", "density"}}}, parts[0], parts[1]}}}});
  for (const std::string& model : material_model_names()) {
    std::vector<std::string> names = common;
    Json needed = Json::array();
    for (const KeyInfo& key : keys_of_law(*find_material(model))) {
      names.push_back(name_in_material(key.path));
      if (key.required && key.instead.empty()) needed.push_back(names.back());
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const Json one_of_it = {
        {"required", {"model"}}, {"properties", {{"model", {{"const", model}}}}}, {"not", {{"anyOf", parts}}}};
    rules.push_back({{"if", one_of_it}, {"then", {{"propertyNames", {{"enum", names}}}, {"required", needed}}}});
  }
  return rules;
}

void add_required(Json& root)
{
  for (const KeyInfo& key : all_keys()) {
    const std::vector<std::string> parts = split_path(key.path);
    if (!key.required || parts.size() < 2 || parts[0] == "material" || parts[0] == "mesh") continue;
    value_at(root, key.path.substr(0, key.path.rfind('.')))["required"].push_back(parts.back());
  }
  for (const SectionInfo& section : all_sections())
    if (section.required && section.path != "time") root["required"].push_back(split_path(section.path)[0]);
  const auto any_of = [](std::initializer_list<const char*> names) {
    Json list = Json::array();
    for (const char* name : names) list.push_back({{"required", {name}}});
    return Json{{"anyOf", list}};
  };
  Json& body = value_at(root, "body[]");
  body["if"] = any_of({"box", "polygon", "region"});
  body["then"] = {{"required", {"material"}}};
  const Json ends = {{"required", {"time"}}, {"properties", {{"time", any_of({"end", "until", "at_most"})}}}};
  root["anyOf"] = {ends, {{"required", {"stage"}}}};
}

std::vector<KeyInfo> keys_and_those_of_laws()
{
  std::vector<KeyInfo> keys = all_keys();
  for (const std::string& name : material_model_names())
    for (KeyInfo& key : keys_of_law(*find_material(name))) keys.push_back(std::move(key));
  std::ranges::stable_sort(
      keys, std::ranges::greater{}, [](const KeyInfo& key) { return split_path(key.path).size(); });
  return keys;  // the longest first: what a key shares its path with is there
}

}  // namespace

std::string case_schema()
{
  Json root = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Case file of Terp"}};
  for (const SectionInfo& section : all_sections())
    if (!section.path.empty()) value_at(root, section.path)["description"] = section.meaning;
  for (const KeyInfo& key : keys_and_those_of_laws()) add(root, key);
  Json& material = value_at(root, "material.NAME");
  Json& density = material["properties"]["density"];  // "below" and "above" the phreatic line, as the whole soil
  density = either(density, table_of(density));
  Json part = material;
  for (const char* name : {"below", "above"}) part["properties"].erase(name);
  for (const char* name : {"below", "above"}) material["properties"][name] = part;
  root["definitions"]["field"] = field_schema();
  close_tables(root);
  add_required(root);
  value_at(root, "material.NAME")["allOf"] = rules_of_soil();
  return root.dump(2) + '\n';
}

}  // namespace terp
