// Tables of a list go by their names, since a person may put one in front of the others. What a person writes in
// another way is no change: numbers are compared in SI, lines by their heights, outlines by corners. Only then words
// are sought: both values in the unit of the import, a table that is new or gone as a whole.

#include "io/results/import_changes.hpp"

#include "math/utf8.hpp"
#include "io/case/keys.hpp"
#include "io/case/units.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "model/bodies/polygon.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace terp {
namespace {

namespace said {

constexpr SentenceForm as_it_is{"`{}`", "`{}`"};
constexpr SentenceForm soil{"{}", "{}"}, layer{"Layer `{}`", "Laag `{}`"}, load{"Load `{}`", "Belasting `{}`"},
    stage{"Stage `{}`", "Fase `{}`"}, situation{"Water `{}`", "Water `{}`"};
constexpr SentenceForm first_water{"Water at the start", "Water aan het begin"}, flood{"Flood", "Overstroming"};
constexpr SentenceForm key_of{"{}: {}", "{}: {}"}, with_unit{"{:.10g} {}", "{:.10g} {}"};
constexpr SentenceForm changed{"{} was {} in the import, is {} here.", "{} was bij het inlezen {}, is hier {}."};
constexpr SentenceForm gone{
    "{} was {} in the import, is not given here.", "{} was bij het inlezen {}, is hier niet gegeven."};
constexpr SentenceForm added{"{} was not given by the import, is {} here.", "{} gaf het inlezen niet, is hier {}."};
constexpr SentenceForm table_gone{"{} of the import is not here.", "{} van het inlezen is hier niet."};
constexpr SentenceForm table_added{"{} is not of the import.", "{} is niet van het inlezen."};
constexpr SentenceForm line_moved{"{} was at {:.2f} m in the import, is at {:.2f} m here, at x = {:.2f} m.",
    "{} lag bij het inlezen op {:.2f} m, ligt hier op {:.2f} m, bij x = {:.2f} m."};
constexpr SentenceForm outline_moved{"{}: corners of its outline moved by up to {:.3g} m since the import.",
    "{}: hoekpunten van de omtrek zijn sinds het inlezen tot {:.3g} m verplaatst."};
constexpr SentenceForm outline_changed{
    "{}: its outline had {} corners and {:.2f} m2 in the import, has {} and {:.2f} m2 here.",
    "{}: de omtrek had bij het inlezen {} hoekpunten en {:.2f} m2, heeft hier {} en {:.2f} m2."};
constexpr SentenceForm no_record{
    "What changed since the import is not known: {}", "Wat sinds het inlezen is veranderd, is niet bekend: {}"};

}  // namespace said

struct KeyWord {
  std::string_view key;
  Sentence word;
};

Sentence word_of_key(const std::string& key)
{
  static const std::array words{KeyWord{"density", {"weight", "gewicht"}}, KeyWord{"cohesion", {"cohesion", "cohesie"}},
      KeyWord{"friction_angle", {"friction angle", "hoek van inwendige wrijving"}},
      KeyWord{"dilatancy_angle", {"dilatancy angle", "dilatantiehoek"}}, KeyWord{"su_peak", {"s_u", "s_u"}},
      KeyWord{"su_peak.shansep.S", {"S", "S"}}, KeyWord{"su_peak.shansep.m", {"m", "m"}},
      KeyWord{"su_peak.shansep.pop", {"POP", "POP"}}, KeyWord{"su_peak.shansep.minimum", {"least s_u", "kleinste s_u"}},
      KeyWord{"su_peak.table", {"table of s_u", "tabel van s_u"}},
      KeyWord{"shear_modulus", {"shear modulus", "schuifmodulus"}}, KeyWord{"stiffness_ratio", {"G / s_u", "G / s_u"}},
      KeyWord{"poisson_ratio", {"Poisson's ratio", "poissonverhouding"}}, KeyWord{"k0", {"K0", "K0"}},
      KeyWord{"material", {"soil", "grond"}}, KeyWord{"pressure", {"pressure", "druk"}},
      KeyWord{"phreatic_line", {"phreatic line", "freatische lijn"}},
      KeyWord{"water_level", {"river level", "rivierstand"}}};
  const auto found = std::ranges::find(words, key, &KeyWord::key);
  return found == words.end() ? filled<said::as_it_is>(key) : found->word;
}

/// "material.clay" -> clay; "water.situation[high]" -> Water `high`.
Sentence word_of_owner(const std::string& owner)
{
  if (owner == "water") return filled<said::first_water>();
  if (owner == "flood") return filled<said::flood>();
  if (owner.starts_with("material.")) return filled<said::soil>(owner.substr(9));
  const std::size_t opens = owner.find('['), closes = owner.find(']');
  if (opens != std::string::npos && closes + 1 == owner.size()) {
    const std::string kind = owner.substr(0, opens), name = owner.substr(opens + 1, closes - opens - 1);
    if (kind == "body") return filled<said::layer>(name);
    if (kind == "load") return filled<said::load>(name);
    if (kind == "stage") return filled<said::stage>(name);
    if (kind == "water.situation") return filled<said::situation>(name);
  }
  return filled<said::as_it_is>(owner);
}

struct ImportedValue {
  std::string owner, key;  ///< "body[Clay]", "material"
  std::string path;        ///< in the file
  const Node* node;
};

/// "clay: weight"; keys at the top of the case have no owner.
Sentence key_words(const ImportedValue& value)
{
  const Sentence key = word_of_key(value.key);
  return value.owner.empty() ? key : filled<said::key_of>(word_of_owner(value.owner), key);
}

bool does_not_count(const std::string& path, const Node& item)
{
  return path == "title" || path == "reference" || path == "output" || item.name == "color" || item.name == "csv" ||
         item.name == "library";
}

bool is_list_of_tables(const Node& node)
{
  return node.kind == NodeKind::list && !node.items.empty() && node.items[0].kind == NodeKind::table;
}

void collect(const Node& table, const std::string& path, const std::string& owner, const std::string& key,
    std::vector<ImportedValue>& values)
{
  for (const Node& item : table.items) {
    const std::string at = join_path(path, item.name), below = key.empty() ? item.name : join_path(key, item.name);
    if (does_not_count(at, item)) continue;
    if (is_list_of_tables(item)) {
      for (std::size_t k = 0; k < item.items.size(); ++k) {
        const Node* const name = find_item(item.items[k], "name");
        const std::string inside = name != nullptr ? name->text : fmt::format("{}", k + 1);
        collect(item.items[k], fmt::format("{}[{}]", at, k),
            fmt::format("{}[{}]", owner.empty() ? below : join_path(owner, below), inside), "", values);
      }
    } else if (item.kind == NodeKind::table) {
      if (path.empty() && item.name != "material")
        collect(item, at, at, "", values);
      else if (path == "material")
        collect(item, at, "material." + item.name, "", values);
      else
        collect(item, at, owner, path.empty() ? "" : below, values);
    } else if (item.name != "name") {
      values.push_back({owner, below, at, &item});
    }
  }
}

/// S, m and OCR stand in a field of stresses and have no unit.
std::string unit_of(const ImportedValue& value)
{
  for (const char* const name : {".shansep.S", ".shansep.m", ".ocr"})
    if (value.path.ends_with(name)) return "-";
  return unit_at(value.path);
}

/// 8e3 and "8 kPa" are the same.
bool is_equal_value(const ImportedValue& a, const ImportedValue& b)
{
  if (const auto x = number_of(*a.node, unit_of(a)), y = number_of(*b.node, unit_of(b)); x && y) return *x == *y;
  return toml_value(*a.node) == toml_value(*b.node);
}

/// As it stands in the file, with the unit of a plain number.
Sentence value_words(const ImportedValue& value)
{
  constexpr std::size_t most = 60;
  const Node& node = *value.node;
  const std::string unit = unit_of(value);
  std::string text = node.kind == NodeKind::text ? node.text : toml_value(node);
  if (node.kind != NodeKind::text && number_of(node, "-")) {
    text = fmt::format("{}", *number_of(node, "-"));
    if (!unit.empty() && unit != "-") text += " " + unit;
  }
  if (text.size() > most) text = text.substr(0, most) + "...";
  Sentence words{as_utf8(text), as_utf8(text)};
  if (number_of(node, unit)) std::ranges::replace(words.nl, '.', ',');
  return words;
}

/// The unit of a text like "8 kPa", as it was written; empty: it is another value.
std::string written_unit(const ImportedValue& value)
{
  if (value.node->kind != NodeKind::text || !number_of(*value.node, unit_of(value))) return "";
  return parse_quantity(value.node->text)->name;
}

/// In that unit, where it is a number and was written in another one.
Sentence value_words_in(const std::string& unit, const ImportedValue& value)
{
  const auto number = number_of(*value.node, unit_of(value));
  if (!number || unit.empty() || written_unit(value) == unit) return value_words(value);
  Node one;
  one.kind = NodeKind::text, one.text = "1 " + unit;
  const auto scale = number_of(one, unit_of(value));
  return scale ? filled<said::with_unit>(*number / *scale, unit) : value_words(value);
}

bool is_line(const std::string& key)
{
  return key == "phreatic_line" || key == "line" || key.starts_with("head_lines.");
}

bool is_outline(const std::string& key) { return key == "polygon" || key == "box"; }

/// Places of a line [m]; nothing where the value is no line.
std::vector<Vec<2>> places_of(const Node& node)
{
  std::vector<Vec<2>> places;
  for (const Node& item : node.items) {
    if (item.kind != NodeKind::list || item.items.size() != 2) return {};
    const auto x = number_of(item.items[0], "m"), y = number_of(item.items[1], "m");
    if (!x || !y || !std::isfinite(*x + *y)) return {};
    places.push_back({*x, *y});
  }
  return places;
}

/// Empty if no corner moved: 0.5 and "50 cm" are the same.
Sentence outline_sentence(const Sentence& owner, const std::vector<Vec<2>>& before, const std::vector<Vec<2>>& now)
{
  Real moved = 0.0;
  for (std::size_t k = 0; k < before.size() && before.size() == now.size(); ++k)
    moved = std::max(moved, std::hypot(now[k][0] - before[k][0], now[k][1] - before[k][1]));
  if (before.size() == now.size()) return moved > 0.0 ? filled<said::outline_moved>(owner, moved) : Sentence{};
  return filled<said::outline_changed>(
      owner, before.size(), std::abs(signed_area(before)), now.size(), std::abs(signed_area(now)));
}

/// Where the two lines differ most; empty if they are one.
Sentence line_sentence(const Sentence& words, const std::vector<Vec<2>>& before, const std::vector<Vec<2>>& now)
{
  Real most = 0.0, at = 0.0;
  for (const auto* line : {&before, &now})
    for (const Vec<2>& place : *line)
      if (const Real off = std::abs(elevation_at(now, place[0]) - elevation_at(before, place[0])); off > most)
        most = off, at = place[0];
  if (!(most > 0.0)) return {};
  return filled<said::line_moved>(words, elevation_at(before, at), elevation_at(now, at), at);
}

Sentence change_sentence(const ImportedValue& before, const ImportedValue& now)
{
  const std::vector<Vec<2>> first = places_of(*before.node), second = places_of(*now.node);
  const bool are_places = !first.empty() && !second.empty();
  if (are_places && is_outline(now.key)) return outline_sentence(word_of_owner(now.owner), first, second);
  if (are_places && is_line(now.key)) return line_sentence(key_words(now), first, second);
  const std::string imported = written_unit(before), unit = imported.empty() ? written_unit(now) : imported;
  return filled<said::changed>(key_words(now), value_words_in(unit, before), value_words_in(unit, now));
}

const ImportedValue* find_value(const std::vector<ImportedValue>& values, const ImportedValue& wanted)
{
  const auto found = std::ranges::find_if(
      values, [&](const ImportedValue& value) { return value.owner == wanted.owner && value.key == wanted.key; });
  return found == values.end() ? nullptr : &*found;
}

/// Values of one case that the other one does not have; a table as a whole in one sentence.
template <const SentenceForm& of_value, const SentenceForm& of_table>
void add_of_one(
    const std::vector<ImportedValue>& values, const std::vector<ImportedValue>& other, std::vector<Sentence>& sentences)
{
  std::set<std::string> known{""}, reported;  // the top of a case is always there
  for (const ImportedValue& value : other) known.insert(value.owner);
  for (const ImportedValue& value : values) {
    if (!known.contains(value.owner)) {
      if (reported.insert(value.owner).second) sentences.push_back(filled<of_table>(word_of_owner(value.owner)));
    } else if (find_value(other, value) == nullptr) {
      sentences.push_back(filled<of_value>(key_words(value), value_words(value)));
    }
  }
}

}  // namespace

std::vector<Sentence> import_changes(const Node& imported, const Node& now)
{
  std::vector<ImportedValue> before, after;
  collect(imported, "", "", "", before);
  collect(now, "", "", "", after);
  std::vector<Sentence> sentences;
  for (const ImportedValue& value : after)
    if (const ImportedValue* const first = find_value(before, value);
        first != nullptr && !is_equal_value(*first, value))
      if (Sentence sentence = change_sentence(*first, value); !sentence.empty())
        sentences.push_back(std::move(sentence));
  add_of_one<said::added, said::table_added>(after, before, sentences);
  add_of_one<said::gone, said::table_gone>(before, after, sentences);
  return sentences;
}

std::vector<Sentence> changes_since_import(const Node& now, const std::string& folder)
{
  const Node* const name = find_node(now, "reference.imported");
  if (name == nullptr || name->kind != NodeKind::text) return {};
  try {
    return import_changes(parse_toml(read_file(path_in(folder, name->text))), now);
  } catch (const std::exception& error) {
    return {filled<said::no_record>(std::string(error.what()))};
  }
}

}  // namespace terp
